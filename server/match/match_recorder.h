#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recorder.h"

namespace platon {

/// Bytes of a round's recording that follow on those given before.
struct RecordingPiece {
  std::uint32_t round = 0;
  std::string title;        ///< of the level
  std::uint32_t ticks = 0;  ///< of the round so far
  bool last = false;        ///< nothing follows in this round
  std::vector<std::uint8_t> bytes;
};

/// Makes one recording of each round, as pieces that can be written away as they come.
class MatchRecorder {
 public:
  /// `game` is about to be advanced in round `round`. Begins a recording unless one is being made.
  void begin(std::uint32_t round, const Game& game);
  /// `game` has just been advanced by `inputs`, and now has this hash.
  void record(std::span<const Input> inputs, const Game& game, std::uint64_t hash);
  /// The game goes no further; nothing when none was begun.
  void finish(const Game& game);

  /// The pieces since the last call, in order.
  std::vector<RecordingPiece> take() { return std::exchange(pieces_, {}); }

 private:
  void give(const Game& game, bool last);

  std::uint32_t round_ = 0;
  std::optional<Recorder> recorder_;
  std::vector<RecordingPiece> pieces_;
};

}  // namespace platon
