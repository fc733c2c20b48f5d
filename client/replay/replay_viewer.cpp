#include "client/replay/replay_viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "client/netcode/player_watch.h"

namespace platon {

ReplayViewer::ReplayViewer(std::shared_ptr<const Replay> replay)
    : player_(std::move(replay)), stage_(makeStageModel(player_.game().level())) {}

void ReplayViewer::handle(const KeyEvent& event) {
  if (event.kind == KeyEvent::Kind::kRelease) return;
  const bool back = event.key == Key::kArrowLeft || event.key == Key::kPadLeft;
  if (!back && event.key != Key::kArrowRight && event.key != Key::kPadRight) {
    if (event.kind == KeyEvent::Kind::kPress) press(event.key);
    return;
  }
  const int ticks = event.kind == KeyEvent::Kind::kRepeat ? kHeldTicks : 1;
  if (event.shift) return goBy(back ? -kLeapTicks : kLeapTicks);
  player_.step(back ? -ticks : ticks);
}

void ReplayViewer::press(Key key) {
  switch (key) {
    case Key::kSpace:
    case Key::kPadA:
      return player_.togglePause();
    case Key::kPlus:
    case Key::kPadUp:
      return player_.faster();
    case Key::kMinus:
    case Key::kPadDown:
      return player_.slower();
    case Key::kPadLeftBumper:
      return goBy(-kLeapTicks);
    case Key::kPadRightBumper:
      return goBy(kLeapTicks);
    case Key::kTab:
    case Key::kPadBack:
      return player_.followNext();
    default:
      return;
  }
}

void ReplayViewer::goBy(std::int32_t ticks) {
  const std::int64_t target = std::int64_t{player_.tick()} + ticks;
  player_.seek(static_cast<std::uint32_t>(std::max<std::int64_t>(target, 0)));
}

void ReplayViewer::handle(const PointerEvent& event, glm::vec2 screen) {
  const bool left = event.button == PointerEvent::Button::kLeft;
  if (event.kind == PointerEvent::Kind::kRelease && left) dragging_ = false;
  if (event.kind == PointerEvent::Kind::kPress && left) {
    dragging_ = replayBarAt(event.place, screen).has_value();
    if (!dragging_ && !isOnReplayBar(event.place, screen)) player_.togglePause();
  }
  const bool moves = event.kind == PointerEvent::Kind::kMove || event.kind == PointerEvent::Kind::kPress;
  if (!dragging_ || !moves) return;
  player_.seek(static_cast<std::uint32_t>(std::lround(replayBarNear(event.place, screen) * player_.replay().ticks())));
}

void ReplayViewer::advance(double seconds) {
  if (!dragging_) player_.advance(seconds);
}

// As in a game, where a player who is alone has all the time it wants.
bool ReplayViewer::timed() const { return player_.game().presentPlayers() > 1; }

Scene ReplayViewer::scene() const {
  const Game& game = player_.game();
  SceneSource source;
  source.stage = stage_;
  source.game = &game;
  source.timed = timed();
  source.fraction = player_.fraction();
  source.others = player_.players();
  source.localSlot = player_.followed();
  if (player_.followed() < game.slots()) source.attempt.observe(game.tick(), game.player(player_.followed()));
  return makeScene(source);
}

ReplayStatus ReplayViewer::status() const {
  return {player_.tick(), player_.replay().ticks(), player_.speed(), player_.paused()};
}

}  // namespace platon
