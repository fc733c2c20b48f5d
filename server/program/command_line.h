#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/app/server_options.h"

namespace platon {

/// What `platon-server` is asked to do.
enum class ServerTask { kServe, kConsole, kPrintConfig, kCheckConfig };

/// The command line of the server.
struct CommandLine {
  ServerTask task = ServerTask::kServe;
  std::string config;              ///< configuration file; empty: none
  ServerOptions given;             ///< with the values that are given
  std::vector<std::string> names;  ///< of the options that are given
};

/// Reads the command line. Returns nothing after printing help or version. Throws ProgramError.
std::optional<CommandLine> readCommandLine(int argc, const char* const* argv);

/// Options of the server, and what is wrong with the configuration file, a line for each error.
struct OptionsResult {
  ServerOptions options;
  std::vector<std::string> errors;
};

/// Reads the configuration file of the command line. The options of the command line override it.
OptionsResult readOptions(const CommandLine& line);
/// The options. Throws ProgramError with the first error of the configuration file.
ServerOptions optionsOf(const CommandLine& line);

}  // namespace platon
