#include "client/play/offscreen/benchmark_game.h"

#include <string>
#include <utility>

namespace platon {
namespace {

std::vector<std::string> namesOfPlayers() {
  std::vector<std::string> names;
  for (std::uint32_t slot = 0; slot < BenchmarkGame::kPlayers; ++slot)
    names.push_back("Player " + std::to_string(slot + 1));
  return names;
}

}  // namespace

BenchmarkGame::BenchmarkGame(std::shared_ptr<const Level> level) : game_(std::move(level), namesOfPlayers()) {}

void BenchmarkGame::advance(std::uint32_t ticks) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) advance();
}

void BenchmarkGame::advance() {
  if (game_.game().tick() > 0 && game_.game().over()) {
    game_.begin();
    inputs_.clear();
  }
  inputs_.push_back(demo_.choose(game_.game(), 0));
  std::vector<Input> inputs(kPlayers);
  for (std::uint32_t slot = 0; slot < kPlayers; ++slot) {
    const std::size_t delay = std::size_t{slot} * kTicksBetween;
    if (delay < inputs_.size()) inputs[slot] = inputs_[inputs_.size() - 1 - delay];
    inputs[slot].buttons |= Input::kPresent;
  }
  game_.advance(inputs);
}

}  // namespace platon
