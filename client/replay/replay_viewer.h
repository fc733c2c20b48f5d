#pragma once

#include <memory>

#include "client/replay/replay_player.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"
#include "client/ui/replay_bar.h"

namespace platon {

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
