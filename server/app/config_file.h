#pragma once

#include <string>

#include "server/app/server_options.h"

namespace platon {

/// Reads a configuration file (docs/hosting.md) into `options`; options that it does not contain keep their values.
/// Paths are relative to the folder of the file. Throws ProgramError, with file, line and column, if the file cannot
/// be read or has an unknown key or an invalid value.
void readConfigFile(const std::string& path, ServerOptions& options);

}  // namespace platon
