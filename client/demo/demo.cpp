#include "client/demo/demo.h"

#include <algorithm>

#include "platon/game/player_motion.h"

namespace platon {

namespace {

constexpr std::uint32_t kTicksOfRest = 10;  // longer than a jump press is buffered
constexpr std::uint32_t kMaxTicksOfRest = kTicksPerSecond;
constexpr std::uint32_t kMaxTicksToRest = 5 * kTicksPerSecond;
constexpr std::size_t kMaxStates = 400000;  // of a search: some 100 MB
constexpr std::int32_t kHaste = 2;          // weight of the ticks that are left against those of the way
constexpr std::uint32_t kFar = 1U << 30;    // ticks to a goal that is not reached along the surface

Input pressing(Input input, std::uint8_t button) { return {static_cast<std::uint8_t>(input.buttons | button)}; }

}  // namespace

Demo::Motion Demo::motionOf(const Game& game, std::uint32_t slot) {
  const EntityState& entity = game.world().entities()[slot];
  return {entity.part, entity.position, game.player(slot).velocity, entity.angle};
}

Input Demo::choose(const Game& game, std::uint32_t slot) {
  if (game.sharedLevel() != level_ || game.tick() < tick_) startRound(game);
  tick_ = game.tick();
  if (slot >= game.slots() || game.player(slot).present == 0 || game.over()) return {};
  // On the way, another player may need this one.
  if (game.player(slot).finished() && (!way_ || level_->players == 1)) return {};
  const Motion now = motionOf(game, slot);
  restingTicks_ = last_ == now ? restingTicks_ + 1 : 0;
  last_ = now;
  const bool isAsPlanned = step_ < plan_.size() && now == expected_[step_];
  if (isAsPlanned && !isCommonStart(tick_) && !waitsInVain(game)) return plan_[step_++];
  plan_.clear();
  return way_ ? beginWay(game, slot) : waitForRest(game, slot);
}

void Demo::startRound(const Game& game) {
  if (game.sharedLevel() != level_) {
    level_ = game.sharedLevel();
    way_ = wayOf_ ? wayOf_(*level_) : std::nullopt;
    distance_.reset();
  }
  plan_.clear();
  search_.reset();
  last_.reset();
  waitedTicks_ = 0;
}

// On a level for several players, those of all clients begin the way again in the same ticks of the round, whenever
// they have joined.
bool Demo::isCommonStart(std::uint32_t tick) const {
  return way_ && level_->players > 1 && tick % (way_->size() + kTicksPerSecond) == 0;
}

// For a player who is not there.
bool Demo::waitsInVain(const Game& game) const {
  return restingTicks_ >= kMaxTicksOfRest && game.presentPlayers() < level_->players;
}

// A restart leads to the state with which the round of the recording began. It needs a tick in which it is not held.
Input Demo::beginWay(const Game& game, std::uint32_t slot) {
  if ((game.player(slot).held & Input::kRestart) != 0 || isCommonStart(tick_ + 1)) return {};
  Solution plan = *way_;
  for (std::vector<Input>& tick : plan) {
    if (slot < tick.size()) continue;
    tick.resize(slot + 1);
    tick[slot] = tick.front();
  }
  for (Input& first : plan.front()) {
    if (first.buttons != 0) first = pressing(first, Input::kRestart);
  }
  adopt(game, slot, plan);
  return plan_[step_++];
}

Input Demo::waitForRest(const Game& game, std::uint32_t slot) {
  if (restingTicks_ < kTicksOfRest) {
    search_.reset();
    return ++waitedTicks_ > kMaxTicksToRest ? restartPlayer() : Input{};
  }
  waitedTicks_ = 0;
  return search(game, slot);
}

WaySearch::Limits Demo::limitsOfSearch(std::uint32_t slot) {
  if (!distance_) distance_ = std::make_shared<GoalDistance>(*level_);
  WaySearch::Limits limits;
  limits.states = kMaxStates;
  limits.ticksLeft = [distance = distance_, slot](const Game& game) {
    const EntityState& entity = game.world().entities()[slot];
    const std::int32_t left = distance->from({entity.part, entity.position}, game.openDoors());
    const bool isReachable = left != GoalDistance::kUnreachable;
    return isReachable ? static_cast<std::uint32_t>(kHaste * (left / motion::kRunSpeed)) : kFar;
  };
  return limits;
}

Input Demo::search(const Game& game, std::uint32_t slot) {
  if (!search_) search_.emplace(game, slot, limitsOfSearch(slot));
  const bool goesOn = search_->work(effort_);
  const WaySearch::Target goal;
  if (!search_->found().contains(goal)) return goesOn ? Input{} : restartPlayer();
  Solution plan;
  for (const Input input : search_->inputsTo(goal)) {
    plan.emplace_back(game.slots(), Input{Input::kPresent});
    plan.back()[slot] = input;
  }
  adopt(game, slot, plan);
  return plan_[step_++];
}

void Demo::adopt(const Game& start, std::uint32_t slot, const Solution& plan) {
  search_.reset();
  step_ = 0;
  plan_.clear();
  expected_.clear();
  Game game = start;
  for (const std::vector<Input>& inputs : plan) {
    plan_.push_back(inputs[slot]);
    expected_.push_back(motionOf(game, slot));
    game.advance(inputs);
  }
}

Input Demo::restartPlayer() {
  search_.reset();
  waitedTicks_ = 0;
  return {Input::kRestart};
}

}  // namespace platon
