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

/// The recording of a game's last minutes, in bounded memory: the oldest goes as the newest comes.
class RecentRecording {
 public:
  /// Nothing is written away, so checkpoints only serve to drop what is old.
  static constexpr std::uint32_t kTicksBetweenCheckpoints = 10 * kTicksPerSecond;
  /// A whole round of 16 players has about a quarter of it.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  /// `start` is the game before the first tick to be recorded.
  explicit RecentRecording(const Game& start);

  /// `game` has just been advanced by `inputs`.
  void record(std::span<const Input> inputs, const Game& game);
  /// The recording, which ends with `game`. Nothing more can be recorded.
  std::vector<std::uint8_t> finish(const Game& game);

 private:
  Recorder recorder_;
  std::vector<std::uint8_t> head_;
  std::deque<std::vector<std::uint8_t>> blocks_;  // from one checkpoint to the next
  std::size_t bytes_ = 0;                         // of the blocks
};

}  // namespace platon
