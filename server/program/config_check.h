#pragma once

#include <string>
#include <vector>

#include "server/program/command_line.h"

namespace platon {

/// What `--check-config` reports.
struct ConfigCheck {
  int exitCode = 0;                 ///< of ProgramError: kUsage if any error is not one of a level, otherwise kLevel
  std::vector<std::string> errors;  ///< and warnings, of levels and of ports that are in use, a line each
  std::string summary;              ///< if there is no error
};

/// Reads the configuration and all files that it names: levels, bans, key and password. Tries whether the machine has
/// the addresses, each at any free port, so that a running server does no harm. Warns of a port that is in use while no
/// server answers at the console. Creates and changes no file.
ConfigCheck checkConfig(const CommandLine& line);

}  // namespace platon
