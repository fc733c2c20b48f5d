#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/netcode/player_snapshot.h"
#include "client/replay/replay.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"
#include "client/ui/replay_bar.h"

namespace platon {

/// Plays a replay: forwards at several speeds, tick by tick, and from any tick. Every state it shows is that of a
/// straight play from the start.
class ReplayPlayer {
 public:
  explicit ReplayPlayer(std::shared_ptr<const Replay> replay);

  /// Plays on for `seconds` ≥ 0 of the viewer's time; no effect while paused. Pauses at the end.
  void advance(double seconds);
  /// Goes where `advance` leads in so many seconds ≥ 0 from the start at the normal speed, without playing all that is
  /// before.
  void skipTo(double seconds);
  /// Pauses, or plays on; from the start if all has been played.
  void togglePause();
  /// Pauses one tick further, or with a negative number back. Stops at start and end.
  void step(std::int32_t ticks);
  /// Goes to the state after the first `tick` ticks; beyond the end, to the end. Does not pause.
  void seek(std::uint32_t tick);
  /// The next speed: 0.25, 0.5, 1, 2 or 4; beyond the last, none.
  void faster();
  void slower();
  /// Follows the next player who is present.
  void followNext();

  const Replay& replay() const { return *replay_; }
  const Game& game() const { return game_; }
  /// Recorded ticks that have been played.
  std::uint32_t tick() const { return tick_; }
  bool paused() const { return paused_; }
  double speed() const;
  /// Slot of the player whom the camera follows: who was chosen, else the first who is present.
  std::uint32_t followed() const;
  /// All players between the last tick and the one before.
  InterpolatedPlayers players() const { return {before_, now_, fraction_}; }
  /// Part of the last tick that has passed, 0 … 1.
  double fraction() const { return fraction_; }

 private:
  static constexpr std::uint32_t kNormalSpeed = 2;

  bool isPresent(std::uint32_t slot) const { return slot < game_.slots() && game_.player(slot).present != 0; }
  void playTick();
  void look();
  void show();

  std::shared_ptr<const Replay> replay_;
  Game game_;
  std::uint32_t tick_ = 0;
  double fraction_ = 1;
  bool paused_ = false;
  std::uint32_t speed_ = kNormalSpeed;  // index
  std::uint32_t followed_ = 0;
  std::vector<PlayerSnapshot> before_;  // by slot
  std::vector<PlayerSnapshot> now_;     // by slot
};

/// Watches a replay: what keys and mouse do to it, and what is to be drawn. It has no window and no clock.
class ReplayViewer {
 public:
  /// Ticks that Shift with an arrow key, LB and RB go forwards or back: 5 s.
  static constexpr std::int32_t kLeapTicks = 5 * kTicksPerSecond;
  /// Ticks of each repetition of an arrow key that is held.
  static constexpr std::int32_t kHeldTicks = 2;

  explicit ReplayViewer(std::shared_ptr<const Replay> replay);

  void handle(const KeyEvent& event);
  /// Places are on a screen of this size. A click on the bar goes there, one on the picture pauses or plays on.
  void handle(const PointerEvent& event, glm::vec2 screen);
  /// Plays on for `seconds`.
  void advance(double seconds);
  /// As ReplayPlayer::skipTo.
  void skipTo(double seconds) { player_.skipTo(seconds); }

  const ReplayPlayer& player() const { return player_; }
  /// The player whom the camera follows is drawn as the local one.
  Scene scene() const;
  ReplayStatus status() const;

 private:
  bool timed() const;
  void goBy(std::int32_t ticks);
  void press(Key key);

  ReplayPlayer player_;
  std::shared_ptr<const StageModel> stage_;
  bool dragging_ = false;  // the mouse was pressed on the bar
};

}  // namespace platon
