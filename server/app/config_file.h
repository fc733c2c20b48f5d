#pragma once

#include <string>

#include "server/app/server_options.h"

namespace platon {

/// Reads a configuration file (docs/hosting.md) over `options`. Relative paths are seen from the file.
/// Throws ProgramError with file, line and column when it cannot be read, has an unknown key or a value that is not
/// possible.
void readConfigFile(const std::string& path, ServerOptions& options);

}  // namespace platon
