#include "client/demo/demo.h"

namespace platon {

namespace {

constexpr std::uint32_t kTicksOfRest = 10;  // longer than a jump press is buffered
constexpr std::uint32_t kMaxTicksToRest = 5 * kTicksPerSecond;

}  // namespace

Demo::Motion Demo::motionOf(const Game& game, std::uint32_t slot) {
  const EntityState& entity = game.world().entities()[slot];
  return {entity.part, entity.position, game.player(slot).velocity, entity.angle};
}

Input Demo::choose(const Game& game, std::uint32_t slot) {
  if (game.sharedLevel() != level_ || game.tick() < tick_) startRound(game);
  tick_ = game.tick();
  const bool inPlay = slot < game.slots() && game.player(slot).present != 0 && !game.player(slot).finished();
  if (!inPlay || game.over()) return {};
  const Motion now = motionOf(game, slot);
  if (step_ < plan_.size() && now == expected_[step_]) return plan_[step_++];
  plan_.clear();
  return waitForRest(game, slot, now);
}

void Demo::startRound(const Game& game) {
  if (game.sharedLevel() != level_) distance_.emplace(game.level());
  level_ = game.sharedLevel();
  plan_.clear();
  planner_.reset();
  last_.reset();
  waitedTicks_ = 0;
}

Input Demo::waitForRest(const Game& game, std::uint32_t slot, const Motion& now) {
  restingTicks_ = last_ == now ? restingTicks_ + 1 : 0;
  last_ = now;
  if (restingTicks_ < kTicksOfRest) {
    planner_.reset();
    return ++waitedTicks_ > kMaxTicksToRest ? restartPlayer() : Input{};
  }
  waitedTicks_ = 0;
  return continuePlanning(game, slot);
}

Input Demo::continuePlanning(const Game& game, std::uint32_t slot) {
  if (!planner_) planner_.emplace(game, slot, *distance_);
  switch (planner_->work(effort_)) {
    case Planner::Status::kSearching:
      break;
    case Planner::Status::kNoPlan:
      return restartPlayer();
    case Planner::Status::kFound:
      adoptPlan(game, slot);
  }
  return {};
}

void Demo::adoptPlan(const Game& start, std::uint32_t slot) {
  plan_ = planner_->plan();
  planner_.reset();
  last_.reset();
  step_ = 0;
  expected_.clear();
  Game game = start;
  std::vector<Input> inputs(slot + 1);
  for (const Input input : plan_) {
    expected_.push_back(motionOf(game, slot));
    inputs[slot] = input;
    game.advance(inputs);
  }
}

Input Demo::restartPlayer() {
  planner_.reset();
  last_.reset();
  waitedTicks_ = 0;
  return {Input::kRestart};
}

}  // namespace platon
