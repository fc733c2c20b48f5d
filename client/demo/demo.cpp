#include "client/demo/demo.h"

namespace platon {

namespace {

constexpr std::uint32_t kTicksOfRest = 10;                // longer than a pressed jump waits
constexpr std::uint32_t kPatience = 5 * kTicksPerSecond;  // to come to rest

}  // namespace

Demo::Motion Demo::motionOf(const Game& game, std::uint32_t slot) {
  const EntityState& entity = game.world().entities()[slot];
  return {entity.part, entity.position, game.player(slot).velocity, entity.angle};
}

Input Demo::choose(const Game& game, std::uint32_t slot) {
  if (game.sharedLevel() != level_ || game.tick() < tick_) startRound(game);
  tick_ = game.tick();
  const bool inPlay = slot < game.slots() && game.player(slot).present != 0 && game.player(slot).finished == 0;
  if (!inPlay || game.over()) return {};
  const Motion now = motionOf(game, slot);
  if (step_ < plan_.size() && now == expected_[step_]) return plan_[step_++];
  plan_.clear();
  return rest(game, slot, now);
}

void Demo::startRound(const Game& game) {
  if (game.sharedLevel() != level_) distance_.emplace(game.level());
  level_ = game.sharedLevel();
  plan_.clear();
  planner_.reset();
  before_.reset();
  waitedTicks_ = 0;
}

Input Demo::rest(const Game& game, std::uint32_t slot, const Motion& now) {
  restingTicks_ = before_ == now ? restingTicks_ + 1 : 0;
  before_ = now;
  if (restingTicks_ < kTicksOfRest) {
    planner_.reset();
    return ++waitedTicks_ > kPatience ? startOver() : Input{};
  }
  waitedTicks_ = 0;
  return think(game, slot);
}

Input Demo::think(const Game& game, std::uint32_t slot) {
  if (!planner_) planner_.emplace(game, slot, *distance_);
  switch (planner_->work(effort_)) {
    case Planner::Status::kSearching:
      break;
    case Planner::Status::kNoWay:
      return startOver();
    case Planner::Status::kFound:
      adopt(game, slot);
  }
  return {};
}

void Demo::adopt(const Game& start, std::uint32_t slot) {
  plan_ = planner_->plan();
  planner_.reset();
  before_.reset();
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

Input Demo::startOver() {
  planner_.reset();
  before_.reset();
  waitedTicks_ = 0;
  return {Input::kRestart};
}

}  // namespace platon
