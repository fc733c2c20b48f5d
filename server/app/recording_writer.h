#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/work/worker.h"
#include "server/app/recording_folder.h"
#include "server/match/played_round.h"

namespace platon {

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
