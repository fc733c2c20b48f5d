#pragma once

#include <optional>
#include <string>

namespace platon {

/// The content of a level file. Of a file that is too long for a level as much as shows that it is. Nothing when the
/// file cannot be read; then `fault` says why.
std::optional<std::string> readLevelFile(const std::string& path, std::string& fault);

}  // namespace platon
