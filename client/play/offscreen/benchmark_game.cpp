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

BenchmarkGame::BenchmarkGame(std::shared_ptr<const Level> level) : game_(std::move(level), namesOfPlayers()) {
  begin();
}

void BenchmarkGame::begin() {
  game_.begin();
  inputs_.clear();
  prediction_.emplace(game_.game(), 0);
}

void BenchmarkGame::advance(std::uint32_t ticks) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) advance();
}

void BenchmarkGame::advance() {
  if (game_.game().tick() > 0 && game_.game().over()) begin();
  std::vector<Input> inputs(kPlayers);
  inputs[0] = demo_.choose(game_.game(), 0);
  for (std::uint32_t slot = 1; slot < kPlayers; ++slot) {
    const std::size_t delay = std::size_t{slot} * kTicksBetween;
    if (delay <= inputs_.size()) inputs[slot] = inputs_[inputs_.size() - delay][0];
  }
  for (Input& input : inputs) input.buttons |= Input::kPresent;
  game_.advance(inputs);
  inputs_.push_back(std::move(inputs));
}

void BenchmarkGame::predict() {
  const std::uint32_t tick = prediction_->predictedTicks();
  if (tick >= inputs_.size()) return;
  if (tick >= kLead) {
    prediction_->confirm(inputs_[prediction_->confirmedTicks()]);
    prediction_->reconcile(Moment());
  }
  prediction_->predict(inputs_[tick][0]);
}

}  // namespace platon
