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

/// The folder that recordings are written to, a file for each round.
class RecordingFolder {
 public:
  using Time = std::chrono::system_clock::time_point;

  /// Makes the folder when it is missing. Throws ProgramError when no file can be written there.
  explicit RecordingFolder(std::filesystem::path folder);

  /// Appends to the file of the piece's round; a new round's file is named after `now`. When that fails, the log says
  /// why, and what follows of the round is left out.
  void write(const RecordingPiece& piece, Time now, Log& log);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void open(const RecordingPiece& piece, Time now);
  bool append(const RecordingPiece& piece);

  std::filesystem::path folder_;
  std::uint32_t round_ = 0;                 // of the file
  std::filesystem::path path_;              // of the file
  std::unique_ptr<std::FILE, Close> file_;  // null when it could not be written
  std::uint64_t bytes_ = 0;                 // written to it
};

/// `20261121T180501Z-round-0003-first-steps`: sorts by time. The title may be any text.
std::string recordingName(RecordingFolder::Time start, std::uint32_t round, const std::string& title);

}  // namespace platon
