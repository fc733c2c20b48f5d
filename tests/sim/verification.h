#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recording_reader.h"
#include "platon/game/state_difference.h"

namespace platon::sim {

/// Where a game that is played again leaves its recording.
struct Divergence {
  std::uint32_t tick = 0;  ///< the first after which the hashes differ
  std::uint64_t here = 0;  ///< hash after it, as played
  std::uint64_t recorded = 0;
  std::optional<std::uint32_t> comparedAt;    ///< the first checkpoint from `tick` on; nothing when none is left
  std::optional<StateDifference> difference;  ///< there, played against recorded; nothing when no field differs
};

/// What playing a recording again has shown.
struct Verification {
  std::uint32_t firstTick = 0;  ///< before the first tick played
  std::uint32_t ticks = 0;      ///< played, up to and with that of the divergence
  std::uint32_t slots = 0;      ///< of the game at the end
  std::uint64_t hash = 0;       ///< of the game then
  std::optional<Divergence> divergence;
  std::string fault;  ///< of the recording; empty for a whole one
};

/// Plays a recording and compares the hash after every tick and the state at every checkpoint.
class Verifier {
 public:
  using Played = std::function<void(std::span<const Input>, const Game&)>;

  /// From the start of the recording, or from the last checkpoint at or before tick `from`.
  explicit Verifier(std::span<const std::uint8_t> recording, std::uint32_t from = 0);

  /// The game before the first tick to be played; null when the recording cannot be played at all.
  const Game* game() const { return game_ ? &*game_ : nullptr; }
  /// Plays on to the end, or to the first checkpoint behind a divergence. Tells of every tick played.
  Verification run(const Played& played = {});

 private:
  void start(std::uint32_t from);
  bool matches(const RecordedBlock& block);
  void play(const RecordedBlock& block, const Played& played);

  RecordingReader reader_;
  std::optional<RecordedBlock> block_;  // to be played next
  std::optional<Game> game_;
  Verification found_;
};

}  // namespace platon::sim
