#pragma once

#include <optional>
#include <string>

namespace platon {

/// Returns the content of a level file, at most kMaxLevelBytes + 1 bytes of it. Returns nothing and sets `fault` when
/// the file cannot be read.
std::optional<std::string> readLevelFile(const std::string& path, std::string& fault);

}  // namespace platon
