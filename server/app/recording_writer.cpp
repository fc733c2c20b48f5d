#include "server/app/recording_writer.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "protocol/files/blocked_signals.h"

namespace platon {

struct RecordingWriter::Shared {
  struct Task {
    RecordingPiece piece;
    Time now;
  };

  explicit Shared(Write function) : write(std::move(function)) {}

  const Write write;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Task> queue;                // this and all below: under the mutex
  std::size_t bytes = 0;                 // of the queue and of the piece that is being written
  bool writing = false;                  // a piece has left the queue and is not written yet
  bool stopped = false;                  // the writer is gone
  std::optional<std::uint32_t> dropped;  // round that is recorded no further
  std::vector<RecordingEvent> events;
};

RecordingWriter::RecordingWriter(Write write) : shared_(std::make_shared<Shared>(std::move(write))) {
  const BlockedSignals blocked;
  thread_ = std::thread([shared = shared_] { run(*shared); });
}

RecordingWriter::~RecordingWriter() {
  std::unique_lock lock(shared_->mutex);
  shared_->stopped = true;
  shared_->changed.notify_all();
  const bool writing = shared_->writing;
  lock.unlock();
  writing ? thread_.detach() : thread_.join();
}

void RecordingWriter::write(RecordingPiece piece, Time now) {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->dropped == piece.round) return;
  if (shared_->bytes + piece.bytes.size() > kQueueBytes) {
    shared_->dropped = piece.round;
    shared_->events.push_back({RecordingEvent::Kind::kStopped, "", 0, 0, "the disk is too slow"});
    return;
  }
  shared_->bytes += piece.bytes.size();
  shared_->queue.push_back({std::move(piece), now});
  shared_->changed.notify_all();
}

std::vector<RecordingEvent> RecordingWriter::takeEvents() {
  const std::lock_guard lock(shared_->mutex);
  return std::exchange(shared_->events, {});
}

bool RecordingWriter::finish(std::chrono::milliseconds limit) {
  std::unique_lock lock(shared_->mutex);
  return shared_->changed.wait_for(lock, limit, [this] { return shared_->queue.empty() && !shared_->writing; });
}

void RecordingWriter::run(Shared& shared) {
  std::unique_lock lock(shared.mutex);
  for (;;) {
    shared.changed.wait(lock, [&] { return shared.stopped || !shared.queue.empty(); });
    if (shared.stopped) return;
    const Shared::Task task = std::move(shared.queue.front());
    shared.queue.pop_front();
    shared.writing = true;
    lock.unlock();
    std::vector<RecordingEvent> events;
    shared.write(task.piece, task.now, events);
    lock.lock();
    shared.writing = false;
    shared.bytes -= task.piece.bytes.size();
    shared.events.insert(shared.events.end(), events.begin(), events.end());
    shared.changed.notify_all();
  }
}

}  // namespace platon
