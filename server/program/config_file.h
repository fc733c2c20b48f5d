#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/app/server_options.h"

namespace platon {

/// Reads the text of a configuration file (docs/hosting.md) into `options`; options that it does not contain, or
/// contains with an error, keep their values. Paths are relative to the folder of `file`. Returns all errors, each as
/// `file:line:column: error: …`, in the order of the text.
std::vector<std::string> readConfig(std::string_view text, const std::string& file, ServerOptions& options);

/// The same for a file. An error is also that the file cannot be read.
std::vector<std::string> readConfigFile(const std::string& path, ServerOptions& options);

}  // namespace platon
