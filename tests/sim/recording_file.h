#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "platon/game/recorder.h"
#include "tests/sim/files.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {

/// Records the game of a command with the options `--record FILE` and `--checkpoint-every TICKS`. Without `--record`,
/// all functions do nothing.
class RecordingFile {
 public:
  explicit RecordingFile(const Options& options);

  /// True when there is an option `--record`.
  bool enabled() const { return !path_.empty(); }
  /// Opens the file; `game` is the game before the first tick. Throws UsageError when the file cannot be opened.
  void start(const Game& game, OutputFile::Mode mode = OutputFile::Mode::kReplace);
  /// Records one tick: `game` has just been advanced by `inputs`.
  void tick(std::span<const Input> inputs, const Game& game);
  /// Marks the end of the recording and flushes the file.
  void finish(const Game& game);

 private:
  std::uint32_t checkpointTicks_;
  std::string path_;
  std::optional<OutputFile> file_;
  std::optional<Recorder> recorder_;
};

}  // namespace platon::sim
