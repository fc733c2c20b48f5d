#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recorded_run.h"
#include "platon/game/recording_reader.h"
#include "platon/game/state_difference.h"

namespace platon::sim {

/// First difference between a replay and its recording.
struct Divergence {
  std::uint32_t tick = 0;                     ///< first tick after which the hashes differ
  std::uint64_t replayed = 0;                 ///< hash of the replay after that tick
  std::uint64_t recorded = 0;                 ///< hash in the recording
  std::optional<std::uint32_t> comparedAt;    ///< first checkpoint at or after `tick`; nothing when there is none
  std::optional<StateDifference> difference;  ///< at comparedAt, replay left; nothing when no field differs
};

/// Result of a replay.
struct Verification {
  std::uint32_t firstTick = 0;   ///< tick of the game before the replay
  std::uint32_t ticks = 0;       ///< number of ticks replayed, up to and including that of the divergence
  std::uint32_t slots = 0;       ///< slots of the game at the end
  bool beginsInMidGame = false;  ///< with players or open doors: what they did before cannot be verified
  std::uint64_t hash = 0;        ///< hash of the game after the last of `ticks`
  std::optional<Divergence> divergence;
  std::variant<RunFinish, std::string> run;  ///< what it shows; or why that is no run, or is not known, as a clause
  std::string fault;                         ///< error in the recording; empty for a complete one
};

/// Replays a recording and compares the hash after every tick and the state at every checkpoint.
class Verifier {
 public:
  using Played = std::function<void(std::span<const Input>, const Game&)>;

  /// Starts at the last checkpoint at or before tick `from`.
  explicit Verifier(std::span<const std::uint8_t> recording, std::uint32_t from = 0);

  /// The game; null when the recording cannot be replayed at all.
  const Game* game() const { return game_ ? &*game_ : nullptr; }
  /// Part of the blocks, in bytes, that has been replayed: 0 … 1.
  double part() const;
  /// Replays to the end, or to the first checkpoint after a divergence. Calls `played` after every tick.
  Verification run(const Played& played = {});

 private:
  void start(std::uint32_t from);
  bool matches(const RecordedBlock& block);
  void play(const RecordedBlock& block, const Played& played);
  std::variant<RunFinish, std::string> runFound() const;

  RecordingReader reader_;
  std::size_t bytes_;                   // of the recording
  std::size_t begin_ = 0;               // of the first block that is replayed
  bool beginsLater_ = false;            // than the recording
  std::optional<RecordedBlock> block_;  // next to be replayed
  std::optional<Game> game_;
  std::optional<Game> before_;      // the last tick of the last block
  std::optional<RecordedRun> run_;  // once there is a game
  Verification found_;
};

}  // namespace platon::sim
