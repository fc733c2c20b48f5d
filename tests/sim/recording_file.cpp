#include "tests/sim/recording_file.h"

namespace platon::sim {

RecordingFile::RecordingFile(const Options& options)
    : checkpointTicks_(
          static_cast<std::uint32_t>(options.number("checkpoint-every", kCheckpointTicks, 1, kMaxCheckpointTicks))),
      path_(options.text("record", "")) {
  if (options.has("record") && path_.empty()) throw UsageError("--record needs a file name");
}

void RecordingFile::start(const Game& game, OutputFile::Mode mode) {
  if (!enabled()) return;
  file_.emplace(path_, mode);
  recorder_.emplace(game, checkpointTicks_);
}

void RecordingFile::tick(std::span<const Input> inputs, const Game& game) {
  if (!recorder_) return;
  recorder_->record(inputs, game);
  file_->write(recorder_->takeBytes());
}

void RecordingFile::finish(const Game& game) {
  if (!recorder_) return;
  recorder_->finish(game);
  file_->write(recorder_->takeBytes());
  file_->close();
}

}  // namespace platon::sim
