#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "platon/game/recorder.h"
#include "tests/sim/files.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {

/// What `--record FILE` and `--checkpoint-every TICKS` ask for; does nothing without the first.
class RecordingFile {
 public:
  explicit RecordingFile(const Options& options);

  bool wanted() const { return !path_.empty(); }
  /// Before the first tick. Throws UsageError when the file cannot be written.
  void start(const Game& game, OutputFile::Over over = OutputFile::Over::kAnything);
  /// `game` has just been advanced by `inputs`.
  void tick(std::span<const Input> inputs, const Game& game);
  void finish(const Game& game);

 private:
  std::uint32_t checkpointTicks_;
  std::string path_;
  std::optional<OutputFile> file_;
  std::optional<Recorder> recorder_;
};

}  // namespace platon::sim
