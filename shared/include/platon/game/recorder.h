#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recording_format.h"
#include "platon/game/state_bytes.h"

namespace platon {

/// Encodes the recording of a game while it is played. Its bytes can be written to a file as they come; a recording cut
/// off anywhere loses only the ticks after its last checkpoint.
class Recorder {
 public:
  /// `start` is the game before the first recorded tick; it may be in the middle of its round. `checkpointTicks` is 1 …
  /// kMaxCheckpointTicks.
  explicit Recorder(const Game& start, std::uint32_t checkpointTicks = kCheckpointTicks);

  /// Records one tick: `game` has just been advanced by `inputs`.
  void record(std::span<const Input> inputs, const Game& game) { record(inputs, game, game.hash()); }
  /// As above, for a caller that already knows the hash of `game`.
  void record(std::span<const Input> inputs, const Game& game, std::uint64_t hash);
  /// Marks the end, which tells a complete recording from one that was cut off. Nothing may be recorded afterwards.
  void finish(const Game& game);

  /// Returns the bytes encoded since the last call. The first call encodes the head, which takes time in proportion to
  /// the level.
  std::vector<std::uint8_t> takeBytes();

 private:
  void addBlock(const Game& game);
  void addRuns(StateWriter& body, std::uint32_t slot) const;

  std::uint32_t checkpointTicks_;
  std::shared_ptr<const Level> level_;  // null once the head is encoded
  std::vector<std::uint8_t> bytes_;
  // The unfinished block.
  std::uint32_t firstTick_;                 // ticks the game had advanced before the block
  std::vector<std::uint8_t> state_;         // state of the game before the block
  std::vector<std::vector<Input>> inputs_;  // inputs by tick and slot
  std::vector<std::uint64_t> hashes_;       // hash of the game after each tick
};

}  // namespace platon
