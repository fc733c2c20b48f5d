#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "server/app/log.h"
#include "server/match/match_recorder.h"

namespace platon {

/// A folder to which recordings are written, one file for each round.
class RecordingFolder {
 public:
  using Time = std::chrono::system_clock::time_point;

  /// Creates the folder if it is missing. Throws ProgramError if no file can be written there.
  explicit RecordingFolder(std::filesystem::path folder);

  /// Appends a piece to the file of its round. The file of a new round is named after `now`. When writing fails, the
  /// reason is logged and the rest of the round is not recorded.
  void write(const RecordingPiece& piece, Time now, Log& log);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void open(const RecordingPiece& piece, Time now);
  bool append(const RecordingPiece& piece);

  std::filesystem::path folder_;
  std::uint32_t round_ = 0;                 // round of the file
  std::filesystem::path path_;              // path of the file
  std::unique_ptr<std::FILE, Close> file_;  // null if it could not be written
  std::uint64_t bytes_ = 0;                 // bytes written to the file
};

/// Name of a recording, such as `20261121T180501Z-round-0003-first-steps`. Names sort by time. The title may be any
/// text.
std::string recordingName(RecordingFolder::Time start, std::uint32_t round, const std::string& title);

}  // namespace platon
