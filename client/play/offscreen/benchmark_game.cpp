#include "client/play/offscreen/benchmark_game.h"

#include <utility>

namespace platon {

BenchmarkGame::BenchmarkGame(std::shared_ptr<const Level> level)
    : level_(std::move(level)), stage_(makeStageModel(*level_)), game_(level_) {
  for (std::uint32_t slot = 0; slot < kPlayers; ++slot) names_.push_back("Player " + std::to_string(slot + 1));
  begin();
}

void BenchmarkGame::begin() {
  game_ = Game(level_);
  inputs_.clear();
  attempt_ = AttemptTime();
}

void BenchmarkGame::advance(std::uint32_t ticks) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) advance();
  players_.clear();
  for (std::uint32_t slot = 0; slot < kPlayers; ++slot) players_.push_back(snapshotOf(game_, slot));
}

void BenchmarkGame::advance() {
  if (game_.tick() > 0 && game_.over()) begin();
  inputs_.push_back(demo_.choose(game_, 0));
  std::vector<Input> inputs(kPlayers);
  for (std::uint32_t slot = 0; slot < kPlayers; ++slot) {
    const std::size_t delay = std::size_t{slot} * kTicksBetween;
    if (delay < inputs_.size()) inputs[slot] = inputs_[inputs_.size() - 1 - delay];
    inputs[slot].buttons |= Input::kPresent;
  }
  game_.advance(inputs);
  attempt_.observe(game_.tick(), game_.player(0));
}

Scene BenchmarkGame::scene() const {
  SceneSource source;
  source.stage = stage_;
  source.game = &game_;
  source.others = {players_, players_, 1};
  source.localSlot = 0;
  source.names = names_;
  source.attempt = attempt_;
  return makeScene(source);
}

}  // namespace platon
