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
#include "server/match/level_rotation.h"
#include "server/match/updates.h"

namespace platon {

/// The next bytes of a round's recording.
struct RecordingPiece {
  std::uint32_t round = 0;
  std::string title;        ///< title of the level
  std::uint32_t ticks = 0;  ///< ticks of the round so far
  bool last = false;        ///< the recording of this round ends with these bytes
  std::vector<std::uint8_t> bytes;
};

/// Makes a recording of each round, in pieces that can be written to a file during the round. The first piece comes
/// after kMinTicks and holds all from the beginning; a shorter round has no recording. So players that join and leave
/// again do not fill a disk.
class MatchRecorder {
 public:
  /// Ticks of the shortest recording: 5 s.
  static constexpr std::uint32_t kMinTicks = 5 * kTicksPerSecond;

  /// Starts a recording of `game` in round `round`, unless one is in progress. Call it before each advance.
  void begin(std::uint32_t round, const Game& game);
  /// Records that `game` was advanced by `inputs` and now has this hash.
  void record(std::span<const Input> inputs, const Game& game, std::uint64_t hash);
  /// Ends the recording, if one is in progress, with the game's final state.
  void finish(const Game& game);

  /// The pieces since the last call, in order.
  std::vector<RecordingPiece> take() { return std::exchange(pieces_, {}); }

 private:
  void addPiece(const Game& game, bool last);

  std::uint32_t round_ = 0;
  std::uint32_t ticks_ = 0;  // recorded
  std::optional<Recorder> recorder_;
  std::vector<RecordingPiece> pieces_;
};

/// The round that a match plays: its number, its game, the last ticks that were decided, and the recording.
class PlayedRound {
 public:
  /// Round 1 on this level. `isRecorded`: whether rounds are.
  PlayedRound(const LevelPointer& level, bool isRecorded);

  /// Ends the round and starts the next one on this level.
  void start(const LevelPointer& level);
  /// Advances the game by one tick with these inputs, by slot.
  void advance(const std::vector<Input>& inputs);
  /// Ends the recording, if one is in progress. The next tick begins another one.
  void endRecording() { recorder_.finish(game_); }
  /// Pieces of recordings since the last call.
  std::vector<RecordingPiece> takeRecording() { return recorder_.take(); }

  std::uint32_t number() const { return number_; }
  const Game& game() const { return game_; }
  const TickHistory& history() const { return history_; }
  /// Number of decided ticks.
  std::uint32_t ticks() const { return history_.end(); }

 private:
  std::uint32_t number_ = 1;
  Game game_;
  TickHistory history_;
  bool isRecorded_;
  MatchRecorder recorder_;
};

}  // namespace platon
