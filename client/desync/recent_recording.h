#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recorder.h"

namespace platon {

/// Recording of the last minutes of a game, in bounded memory.
class RecentRecording {
 public:
  /// Old ticks are dropped in blocks of this size.
  static constexpr std::uint32_t kTicksBetweenCheckpoints = 10 * kTicksPerSecond;
  /// Soft limit; a whole round of 16 players takes about a quarter of it.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  /// `start`: the game before the first recorded tick.
  explicit RecentRecording(const Game& start);

  /// Records that `game` has been advanced by `inputs`.
  void record(std::span<const Input> inputs, const Game& game);
  /// Ends the recording with the state `game` and returns it. `record` must not be called afterwards.
  std::vector<std::uint8_t> finish(const Game& game);

 private:
  Recorder recorder_;
  std::vector<std::uint8_t> header_;
  std::deque<std::vector<std::uint8_t>> blocks_;  // one per checkpoint, oldest first
  std::size_t blockBytes_ = 0;                    // total size of blocks_
};

}  // namespace platon
