#include "client/replay/replay_viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "client/netcode/player_watch.h"

namespace platon {

namespace {

constexpr std::array<double, 5> kSpeeds{0.25, 0.5, 1, 2, 4};

}  // namespace

ReplayPlayer::ReplayPlayer(std::shared_ptr<const Replay> replay)
    : replay_(std::move(replay)), game_(replay_->gameAfter(0)) {
  show();
}

// The picture is between the last tick and the one before, so a tick is played when its first part is to be seen.
void ReplayPlayer::advance(double seconds) {
  if (paused_) return;
  fraction_ += seconds * kTicksPerSecond * speed();
  for (; fraction_ > 1 && tick_ < replay_->ticks(); fraction_ -= 1) playTick();
  if (fraction_ <= 1) return;
  fraction_ = 1;
  paused_ = true;
}

void ReplayPlayer::skipTo(double seconds) {
  const double passed = std::min(seconds * kTicksPerSecond, static_cast<double>(replay_->ticks()));
  paused_ = passed < seconds * kTicksPerSecond;
  const double last = std::ceil(passed);
  seek(static_cast<std::uint32_t>(std::max(last - 1, 0.0)));
  if (last > 0) playTick();
  fraction_ = last > 0 ? passed - last + 1 : 1;
}

void ReplayPlayer::togglePause() {
  if (paused_ && tick_ == replay_->ticks()) seek(0);
  paused_ = !paused_;
}

void ReplayPlayer::step(std::int32_t ticks) {
  paused_ = true;
  const std::int64_t target = std::int64_t{tick_} + ticks;
  if (ticks == 1 && tick_ < replay_->ticks()) {
    playTick();
    fraction_ = 1;
  } else {
    seek(static_cast<std::uint32_t>(std::max<std::int64_t>(target, 0)));
  }
}

void ReplayPlayer::seek(std::uint32_t tick) {
  tick_ = std::min(tick, replay_->ticks());
  game_ = replay_->gameAfter(tick_);
  show();
}

void ReplayPlayer::faster() { speed_ = std::min<std::uint32_t>(speed_ + 1, kSpeeds.size() - 1); }

void ReplayPlayer::slower() { speed_ = std::max(speed_, 1U) - 1; }

double ReplayPlayer::speed() const { return kSpeeds[speed_]; }

void ReplayPlayer::followNext() {
  const std::uint32_t current = followed();
  for (std::uint32_t i = 1; i <= game_.slots(); ++i) {
    followed_ = (current + i) % game_.slots();
    if (isPresent(followed_)) return;
  }
}

std::uint32_t ReplayPlayer::followed() const {
  if (isPresent(followed_)) return followed_;
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) {
    if (isPresent(slot)) return slot;
  }
  return followed_;
}

void ReplayPlayer::playTick() {
  before_ = now_;
  game_.advance(replay_->inputsOf(tick_++));
  look();
}

void ReplayPlayer::look() {
  now_.clear();
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) now_.push_back(snapshotOf(game_, slot));
}

// Shows the game as it is, without motion.
void ReplayPlayer::show() {
  look();
  before_ = now_;
  fraction_ = 1;
}

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
  if (game.level().players > 1) source.team.observe(game.tick(), teamOf(game));
  return makeScene(source);
}

ReplayStatus ReplayViewer::status() const {
  ReplayStatus status{player_.tick(), player_.replay().ticks(), player_.speed(), player_.paused()};
  status.several = player_.game().presentPlayers() > 1;
  return status;
}

}  // namespace platon
