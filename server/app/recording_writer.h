#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

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
  /// Writes a piece and appends what happened. Called from the thread of the writer only.
  using Write = std::function<void(const RecordingPiece& piece, Time now, std::vector<RecordingEvent>& events)>;

  /// Bytes that may wait to be written.
  static constexpr std::size_t kQueueBytes = std::size_t{16} << 20;
  /// Longest time that `finish` waits for the disk.
  static constexpr std::chrono::seconds kFinishTime{5};

  explicit RecordingWriter(Write write);
  /// Does not wait for the disk: call `finish` before.
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Queues a piece; returns at once.
  void write(RecordingPiece piece, Time now);
  /// What has happened since the last call, in order.
  std::vector<RecordingEvent> takeEvents();
  /// Waits until all pieces are written, for at most `limit`. Returns whether they are.
  bool finish(std::chrono::milliseconds limit = kFinishTime);

 private:
  struct Shared;

  static void run(Shared& shared);

  std::shared_ptr<Shared> shared_;  // with the thread, which outlives the writer if the disk does not answer
  std::thread thread_;
};

}  // namespace platon
