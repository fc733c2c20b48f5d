#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace platon {

/// The text of a file in which the program remembers something, at most `maxBytes` and one; empty if there is no file
/// yet. Nothing if there is one that cannot be read: writing it again would forget what is in it.
std::optional<std::string> readKeptFile(const std::filesystem::path& file, std::size_t maxBytes);

}  // namespace platon
