#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/player.h"

namespace platon {

/// The time of a player's present attempt: it runs from the first input and stops at the goal. The game keeps only the
/// shortest time of a round; this class also remembers that of a slower attempt.
class AttemptTime {
 public:
  /// `player` is the state after `ticks` ticks. Ignored unless `ticks` exceeds that of all earlier calls.
  void observe(std::uint32_t ticks, const PlayerState& player);

  /// 0 before the first input of the attempt.
  std::uint32_t ticks() const { return attempt_; }
  /// Whether the player has touched the goal in this attempt: the time stands still.
  bool arrived() const { return arrived_; }

 private:
  std::uint32_t newest_ = 0;  // last tick observed
  std::uint32_t attempt_ = 0;
  std::uint32_t best_ = 0;  // PlayerState::finishTicks at the last observation
  bool arrived_ = false;
};

/// The players of a level for several as one, for AttemptTime: it starts with the first of them, and arrives with the
/// first one, too.
PlayerState teamOf(const Game& game);

/// Brightness of the short flashes that mark players who land after a long fall or finish. Each flash belongs to the
/// tick of its event: replaying ticks adds none, and it shows when the viewer's clock reaches that tick.
class PlayerFlashes {
 public:
  static constexpr std::uint32_t kTicks = 12;        ///< duration of a flash
  static constexpr std::uint32_t kMinAirTicks = 20;  ///< minimum time in the air for a landing to flash

  /// `player` is the state of `slot` after `ticks` ticks. Ignored unless `ticks` exceeds that of all earlier calls for
  /// this slot.
  void observe(std::uint32_t slot, std::uint32_t ticks, const PlayerState& player);

  /// Brightness of the slot's flash at `tick`: 1 at the event, fading to 0 over kTicks; 0 before the event.
  double brightness(std::uint32_t slot, double tick) const;

 private:
  struct Observed {
    std::uint32_t newest = 0;    // last tick observed
    std::uint32_t airTicks = 0;  // since the player last stood
    bool finished = false;
    std::array<std::uint32_t, 4> flashes{};  // ticks of the last events; ring buffer
    std::size_t count = 0;                   // events so far
  };

  std::vector<Observed> players_;  // by slot
};

/// Counts how often a ball that has left the ground has gone round its solid.
class FallLaps {
 public:
  /// Notes that the ball is on this face. A lap ends on a face on which the ball has been in this lap, after four or
  /// more: who goes round a corner of three faces, or to and fro over an edge, makes none.
  void enter(std::uint32_t face);
  int count() const { return count_; }

 private:
  std::uint32_t face_ = UINT32_MAX;  // none before the first
  std::uint32_t faces_ = 0;          // bit F: on face F in this lap
  int count_ = 0;
};

/// Tells whether the local player falls round the solid for ever. A fall that has lasted for a second is tried out on a
/// copy of the game: with the buttons that the player holds, and with none.
class EndlessFall {
 public:
  static constexpr std::uint32_t kPatience = kTicksPerSecond;  ///< ticks without ground, then the fall is tried out
  /// Simulated for each tick, of all players together: with more than 32, the second lap often tells first.
  static constexpr std::uint32_t kTrialTicks = 64;
  static constexpr std::uint32_t kMaxTrialTicks = 60 * kTicksPerSecond;  ///< a trial of so many does not land
  static constexpr int kHintLaps = 2;     ///< a trial of so many laps does not land; a fall of so many needs the hint
  static constexpr int kRestartLaps = 3;  ///< a fall of so many needs a restart
  static constexpr std::uint32_t kRestartTicks = 12;  ///< so long it is asked for
  static constexpr std::uint32_t kLongCrossings = 4;  ///< of edges, without ground; the recorded ways have at most 3

  /// `game` is the predicted game after `ticks` ticks, with a player in `slot`. Ignored unless `ticks` exceeds that of
  /// all earlier calls: replaying ticks counts none twice.
  void observe(std::uint32_t ticks, const Game& game, std::uint32_t slot);

  /// Whether the path of the player does not land, or its second lap is over. Neither holds any more once it stands,
  /// touches the goal, restarts or leaves.
  bool needsHint() const { return isEndless_ || laps_.count() >= kHintLaps; }
  /// Whether a camera that follows the player would tumble: it falls over edge after edge, or will.
  bool isLong() const { return needsHint() || crossings_ >= kLongCrossings; }
  /// Whether its third lap is over. True for some ticks, because an input may come too late at the server.
  bool needsRestart() const { return newest_ < restartsUntil_; }

 private:
  void tryOut(const Game& game, std::uint32_t slot);
  void beginTrial(const Game& game, std::uint32_t slot, std::uint8_t buttons);
  void endTrial(const Game& game, std::uint32_t slot, bool lands);
  std::optional<bool> advanceTrial(std::uint32_t slot);

  std::uint32_t newest_ = 0;    // last tick observed
  std::uint32_t grounded_ = 0;  // last tick from which the fall is counted
  FallLaps laps_;
  std::uint32_t groundedCrossings_ = 0;  // of the player until grounded_
  std::uint32_t crossings_ = 0;          // since then
  std::uint32_t restartsUntil_ = 0;      // tick
  bool isEndless_ = false;               // what the last trials have told
  std::optional<std::uint8_t> held_;     // buttons that are or were tried out
  std::optional<Game> trial_;            // while one runs
  FallLaps trialLaps_;
  std::uint32_t trialTicks_ = 0;
  std::vector<Input> inputs_;  // of each tick of the trial
};

}  // namespace platon
