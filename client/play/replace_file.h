#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace platon {

/// Replaces the content of a file, or creates it, by a rename, so that the file is never half written. Keeps the access
/// rights of the file, and a symbolic link to it. Returns why that failed, or nothing.
std::optional<std::string> replaceFile(const std::filesystem::path& path, std::string_view text);

}  // namespace platon
