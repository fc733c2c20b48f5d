#include "client/editor/ball_play.h"

#include <array>
#include <utility>

namespace platon {

BallPlay::BallPlay(std::shared_ptr<const Level> level)
    : game_(std::move(level)), stage_(makeStageModel(game_.level())) {
  tick(Input{Input::kPresent});
  before_ = snapshotOf(game_, 0);
}

void BallPlay::tick(Input input) {
  if (game_.slots() > 0) before_ = snapshotOf(game_, 0);
  const std::array<Input, 1> inputs{Input{static_cast<std::uint8_t>(input.buttons | Input::kPresent)}};
  game_.advance(inputs);
  attempt_.observe(game_.tick(), game_.player(0));
}

Scene BallPlay::scene(double fraction) const {
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
