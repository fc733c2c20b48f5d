#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace platon {

/// A file in a folder.
struct DatedFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  std::filesystem::file_time_type date;  ///< when it was written
};

enum class Subfolders : std::uint8_t { kWithout, kWith };

/// The files in a folder that `belongs` accepts by their path, newest first. What cannot be read is left out, also a
/// subfolder.
std::vector<DatedFile> newestFiles(const std::filesystem::path& folder, Subfolders subfolders,
                                   const std::function<bool(const std::filesystem::path&)>& belongs);

/// Removes the last of these files, so that at most `maxFiles` with at most `maxBytes` together are left. Dates tell
/// which are the oldest, since one program keeps each of these files, whose names tell no time and which are whole when
/// they appear, whereas several servers write to a RecordingFolder at once for minutes: there names and locks decide.
void removeOldest(const std::vector<DatedFile>& newestFirst, std::size_t maxFiles, std::uint64_t maxBytes);

}  // namespace platon
