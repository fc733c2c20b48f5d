#include "server/app/recording_writer.h"

#include <utility>

namespace platon {

RecordingWriter::RecordingWriter(Write write)
    : write_(std::make_shared<const Write>(std::move(write))), writing_(startThread, std::chrono::milliseconds(0)) {}

void RecordingWriter::write(RecordingPiece piece, Time now) {
  takeWritten();
  if (dropped_ == piece.round) return;
  if (bytes_ + piece.bytes.size() > kQueueBytes) return stop(piece.round, "the disk is too slow");
  bytes_ += piece.bytes.size();
  const auto shared = std::make_shared<const RecordingPiece>(std::move(piece));
  queue_.push_back({shared->round, shared->bytes.size()});
  writing_.add([write = write_, shared, now](const std::stop_token&) {
    Events events;
    (*write)(*shared, now, events);
    return events;
  });
}

void RecordingWriter::takeWritten() {
  for (auto written = writing_.poll(); written; written = writing_.take()) {
    const Queued piece = queue_.front();
    queue_.pop_front();
    bytes_ -= piece.bytes;
    if (written->value)
      events_.insert(events_.end(), written->value->begin(), written->value->end());
    else
      stop(piece.round, std::move(written->fault));
  }
}

void RecordingWriter::stop(std::uint32_t round, std::string reason) {
  dropped_ = round;
  events_.push_back({RecordingEvent::Kind::kStopped, "", 0, 0, std::move(reason)});
}

RecordingWriter::Events RecordingWriter::takeEvents() {
  takeWritten();
  return std::exchange(events_, {});
}

}  // namespace platon
