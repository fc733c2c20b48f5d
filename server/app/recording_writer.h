#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/work/worker.h"
#include "server/match/played_round.h"

namespace platon {

/// Something that happened to the file of a recording, for the log of the server.
struct RecordingEvent {
  enum class Kind {
    kFinished,  ///< the recording of a round is complete
    kStopped,   ///< the rest of a round is not recorded, for `reason`
    kRemoved,   ///< an old recording made room for new ones
  };

  Kind kind = Kind::kFinished;
  std::string file;         ///< path; empty if it is not known
  std::uint64_t ticks = 0;  ///< of kFinished: length of the recording
  std::uint64_t bytes = 0;  ///< of kFinished and kRemoved: size of the file
  std::string reason;       ///< of kStopped

  friend bool operator==(const RecordingEvent&, const RecordingEvent&) = default;
};

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

/// Writes recordings from a thread of its own, so that a slow disk never delays a tick.
///
/// What waits to be written is bounded: when a piece does not fit, its round is recorded no further. The next round is
/// tried again.
class RecordingWriter {
 public:
  using Time = RecordingFolder::Time;
  using Events = std::vector<RecordingEvent>;
  /// Writes a piece and appends what happened. Called from the thread of the writer only.
  using Write = std::function<void(const RecordingPiece& piece, Time now, Events& events)>;

  /// Bytes that may wait to be written.
  static constexpr std::size_t kQueueBytes = std::size_t{16} << 20;
  /// Longest time that `finish` waits for the disk.
  static constexpr std::chrono::seconds kFinishTime{5};

  /// The destructor does not wait for the disk: call `finish` before.
  explicit RecordingWriter(Write write);

  /// Queues a piece; returns at once.
  void write(RecordingPiece piece, Time now);
  /// What has happened since the last call, in order.
  Events takeEvents();
  /// Waits until all pieces are written, for at most `limit`. Returns whether they are.
  bool finish(std::chrono::milliseconds limit = kFinishTime) { return writing_.finish(limit); }

 private:
  struct Queued {
    std::uint32_t round;
    std::size_t bytes;
  };

  void takeWritten();
  void stop(std::uint32_t round, std::string reason);

  std::shared_ptr<const Write> write_;
  std::deque<Queued> queue_;              // also the piece that is being written
  std::size_t bytes_ = 0;                 // of the queue
  std::optional<std::uint32_t> dropped_;  // round that is recorded no further
  Events events_;
  Worker<Events> writing_;
};

}  // namespace platon
