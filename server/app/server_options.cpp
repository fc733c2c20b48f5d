#include "server/app/server_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include "platon_version.h"
#include "protocol/label.h"
#include "protocol/program_error.h"
#include "server/app/config_file.h"

namespace platon {
namespace {

std::string checkName(const std::string& name) {
  return isLabel(name, kMaxNameBytes)
             ? ""
             : "the name must have at most " + std::to_string(kMaxNameBytes) + " bytes and no control characters";
}

/// Options given on the command line.
struct CommandLine {
  std::string config;
  std::vector<std::string> levels;
  std::optional<std::string> bind;
  std::optional<std::uint16_t> port;
  std::optional<std::uint32_t> maxPlayers;
  std::optional<std::uint32_t> maxPerAddress;
  std::optional<std::string> name;
  std::optional<std::string> logFormat;
  std::optional<std::string> record;
};

void declare(CLI::App& app, CommandLine& line) {
  app.set_version_flag("--version", "platon-server " + std::string(kVersion));
  app.add_option("LEVEL", line.levels, "Level files, played in this order; default: the levels of the game");
  app.add_option("--bind", line.bind, "Address to listen on; default ::, all addresses of this machine, IPv4 and IPv6");
  app.add_option("--port", line.port, "UDP port; default 7777; 0: any free port")->check(CLI::Range(0, UINT16_MAX));
  app.add_option("--max-players", line.maxPlayers, "Largest number of players; default 16")
      ->check(CLI::Range(1u, kMaxPlayers));
  app.add_option("--max-per-address", line.maxPerAddress, "Largest number of connections from one address; default 4")
      ->check(CLI::Range(1u, kMaxPerAddress));
  app.add_option("--name", line.name, "Name of the server; default Platon")->check(checkName);
  app.add_option("--config", line.config, "Configuration file (docs/hosting.md); command-line options override it");
  app.add_option("--log-format", line.logFormat, "Format of the log; default text")
      ->check(CLI::IsMember({"text", "json"}));
  app.add_option("--record", line.record,
                 "Folder for a recording of each round, created if missing; default: no recordings");
}

template <class Value>
void apply(const std::optional<Value>& given, Value& option) {
  if (given) option = *given;
}

void apply(const CommandLine& line, ServerOptions& options) {
  if (!line.levels.empty()) options.levels = line.levels;
  apply(line.bind, options.bind);
  apply(line.port, options.port);
  apply(line.maxPlayers, options.maxPlayers);
  apply(line.maxPerAddress, options.maxPerAddress);
  apply(line.name, options.name);
  apply(line.record, options.record);
  if (line.logFormat) options.logFormat = *line.logFormat == "json" ? LogFormat::kJson : LogFormat::kText;
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::optional<ServerOptions> readOptions(int argc, const char* const* argv) {
  CLI::App app("The dedicated server of Platon.", "platon-server");
  CommandLine line;
  declare(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      throw ProgramError(ProgramError::kUsage, oneLine(error.what()) + " (see platon-server --help)");
    }
    app.exit(error);
    return std::nullopt;
  }
  ServerOptions options;
  if (!line.config.empty()) readConfigFile(line.config, options);
  apply(line, options);
  return options;
}

}  // namespace platon
