#include "client/editor/ball_play.h"

#include <algorithm>
#include <array>
#include <utility>

namespace platon {

namespace {

constexpr double kTickSeconds = 1.0 / kTicksPerSecond;
constexpr double kMaxSeconds = 0.1;  // of play in one picture

}  // namespace

BallPlay::BallPlay(std::shared_ptr<const Level> level, const Camera& camera)
    : game_(std::move(level)), stage_(makeStageModel(game_.level())), camera_(camera) {
  tick(Input());
  before_ = snapshotOf(game_, 0);
}

void BallPlay::advance(double seconds, bool menuOpen) {
  untilTick_ += std::min(seconds, kMaxSeconds);
  for (; untilTick_ >= kTickSeconds; untilTick_ -= kTickSeconds) {
    const HeldKeys held = mapper_.takeHeld();
    tick(menuOpen ? Input() : steering_.input(held, 0, ControlFrame::kPlayer));
  }
  camera_.lerp(scene().focus, stage_->mesh, seconds);
}

void BallPlay::tick(Input input) {
  if (game_.slots() > 0) before_ = snapshotOf(game_, 0);
  if (fall_.needsRestart()) input.buttons |= Input::kRestart;
  const std::array<Input, 1> inputs{Input{static_cast<std::uint8_t>(input.buttons | Input::kPresent)}};
  game_.advance(inputs);
  attempt_.observe(game_.tick(), game_.player(0));
  fall_.observe(game_.tick(), game_, 0);
}

Scene BallPlay::scene() const {
  const double fraction = untilTick_ / kTickSeconds;
  SceneSource source;
  source.stage = stage_;
  source.game = &game_;
  source.fraction = fraction;
  source.localSlot = 0;
  source.local = InterpolatedPlayer{before_, snapshotOf(game_, 0), fraction};
  source.attempt = attempt_;
  return makeScene(source);
}

}  // namespace platon
