#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recording_format.h"
#include "platon/game/state_bytes.h"

namespace platon {

/// Makes the recording of a game while it is played, as bytes that can be written away as they come: what is cut off
/// loses no more than what follows the last checkpoint.
class Recorder {
 public:
  /// `start` is the game before the first tick to be recorded, perhaps in the middle of its round. `checkpointTicks`:
  /// 1 … kMaxCheckpointTicks.
  explicit Recorder(const Game& start, std::uint32_t checkpointTicks = kCheckpointTicks);

  /// `game` has just been advanced by `inputs`.
  void record(std::span<const Input> inputs, const Game& game) { record(inputs, game, game.hash()); }
  /// The same where the game's hash is known already.
  void record(std::span<const Input> inputs, const Game& game, std::uint64_t hash);
  /// Nothing follows: marks the end, so that a recording that was cut off can be told from a whole one.
  void finish(const Game& game);

  /// The bytes since the last call.
  std::vector<std::uint8_t> takeBytes() { return std::exchange(bytes_, {}); }

 private:
  void addBlock(const Game& game);
  void addRuns(StateWriter& body, std::uint32_t slot) const;

  std::uint32_t checkpointTicks_;
  std::vector<std::uint8_t> bytes_;
  // The block that is being filled.
  std::uint32_t first_;                     // tick before which it starts
  std::vector<std::uint8_t> state_;         // then
  std::vector<std::vector<Input>> inputs_;  // by tick, by slot
  std::vector<std::uint64_t> hashes_;       // by tick
};

}  // namespace platon
