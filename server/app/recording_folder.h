#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/recording_event.h"
#include "server/match/played_round.h"

namespace platon {

/// A folder to which recordings are written, one file for each round. The recordings in it, of all servers together,
/// are kept within a limit: the oldest ones are removed first. A file that a server is writing is locked and never
/// removed, nor is a file whose name is not that of a recording. Names tell which are the oldest, since the date of a
/// file changes with each piece and when an operator copies it, whereas the files of `protocol/files/bounded_folder.h`
/// are whole when they appear and have names without a time: there dates decide, without locks.
///
/// A server learns what others write by searching the folder, at the latest after kSpareBytes of its own. So each
/// further server that writes at the same time may exceed the limit by kSpareBytes, or by one piece if that is longer.
class RecordingFolder {
 public:
  using Time = std::chrono::system_clock::time_point;

  /// Bytes that are freed beyond those that are needed, and bytes that are written between two searches of the folder:
  /// a hundredth of the limit, and at most these.
  static constexpr std::uint64_t kSpareBytes = std::uint64_t{16} << 20;

  /// Creates the folder if it is missing. Throws ProgramError if no file can be written there. `limit`: bytes of all
  /// recordings in the folder.
  RecordingFolder(std::filesystem::path folder, std::uint64_t limit);

  /// Appends a piece to the file of its round and appends what happened. The file of a new round is named after the
  /// time at which the round began. When a piece cannot be written, the rest of its round is not recorded.
  void write(const RecordingPiece& piece, Time now, std::vector<RecordingEvent>& events);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void begin(const RecordingPiece& piece, Time now);
  bool open();
  bool append(const RecordingPiece& piece);
  void discardRest();
  bool makeRoom(std::uint64_t bytes, std::vector<RecordingEvent>& events);
  bool isKnownToFit(std::uint64_t bytes) const;
  std::uint64_t spare() const { return std::min(limit_ / 100, kSpareBytes); }

  std::filesystem::path folder_;
  std::uint64_t limit_;
  std::uint32_t round_ = 0;                 // round of the file
  std::filesystem::path path_;              // path of the file
  std::unique_ptr<std::FILE, Close> file_;  // null if it could not be written
  std::uint64_t bytes_ = 0;                 // bytes written to the file
  std::optional<std::uint64_t> known_;      // bytes of all other recordings, when the folder was last searched
  std::uint64_t searchedAt_ = 0;            // bytes written to the file before that search
};

/// Name of a recording, such as `20261121T180501Z-round-0003-first-steps`. Names sort by time. The title may be any
/// text.
std::string recordingName(RecordingFolder::Time start, std::uint32_t round, const std::string& title);

/// Whether a file has a name that a server gives to recordings.
bool isRecordingName(std::string_view file);

}  // namespace platon
