#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace platon {

/// The content of a file. Throws std::runtime_error if it cannot be read.
std::string readText(const std::filesystem::path& file);
std::vector<std::uint8_t> readBytes(const std::filesystem::path& file);

/// Creates or replaces a file. Throws std::runtime_error if it cannot be written.
void writeText(const std::filesystem::path& file, std::string_view text);

/// The files with this extension in a folder and its subfolders, sorted by file name. Throws std::runtime_error if
/// there is none, because a test of each file would then pass without testing anything.
std::vector<std::string> filesIn(const std::filesystem::path& folder, const std::string& extension);

/// The levels that are shipped, in the order of the rotation.
std::vector<std::string> shippedLevels();

/// One level of each solid, with segments on every face, for whoever runs about at random.
std::vector<std::string> solidLevels();

}  // namespace platon
