#include "levels/solve/level_solver.h"

#include <algorithm>
#include <utility>

namespace platon {
namespace {

constexpr int kMaxTicksToRest = 240;
constexpr int kTicksOfRest = 12;  // longer than a jump press is buffered
constexpr std::uint32_t kAtGoal = UINT32_MAX;

bool isDone(const Game& game) {
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    if (!game.player(slot).finished()) return false;
  }
  return true;
}

std::uint32_t placeOf(const WaySearch::Target& target) {
  return target.kind == WaySearch::Target::Kind::kGoal ? kAtGoal : target.element + 1;
}

}  // namespace

std::optional<Solution> LevelSolver::solve(const Limits& limits) {
  states_ = 0;
  return level_->players > 1 ? solveTogether(limits) : solveAlone(limits);
}

std::optional<Solution> LevelSolver::solveAlone(const Limits& limits) {
  Situation start = begin();
  WaySearch search(start.game, 0, limits);
  const bool isFound = search.find({});
  states_ = search.states();
  if (!isFound) return std::nullopt;
  play(start, 0, search.inputsTo({}));
  return start.inputs;
}

// Breadth first: the fewest moves of players.
std::optional<Solution> LevelSolver::solveTogether(const Limits& limits) {
  std::deque<Situation> open;
  std::set<Key> seen;
  open.push_back(begin());
  if (!settle(open.back())) return std::nullopt;
  for (; !open.empty() && states_ < limits.states; open.pop_front()) {
    const Situation& before = open.front();
    for (std::uint32_t slot = 0; slot < before.game.slots(); ++slot) {
      if (before.game.player(slot).arrived != 0) continue;
      Limits left = limits;
      left.states -= states_;
      WaySearch search(before.game, slot, left);
      search.findAll();
      if (limits.stop && limits.stop()) return std::nullopt;
      states_ += search.states();
      for (const auto& [target, way] : search.found()) {
        Situation after = before;
        play(after, slot, search.inputsTo(target));
        after.places[slot] = placeOf(target);
        if (isDone(after.game)) return after.inputs;
        if (settle(after) && seen.emplace(after.places, takenKeys(after.game)).second) open.push_back(std::move(after));
      }
    }
  }
  return std::nullopt;
}

LevelSolver::Situation LevelSolver::begin() const {
  Situation start{Game(level_), {}, std::vector<std::uint32_t>(level_->players)};
  play(start, 0, {Input{Input::kPresent}});
  return start;
}

// The other players press nothing.
void LevelSolver::play(Situation& situation, std::uint32_t slot, const std::vector<Input>& inputs) const {
  for (const Input input : inputs) {
    std::vector<Input> all(level_->players, Input{Input::kPresent});
    all[slot] = input;
    situation.game.advance(all);
    situation.inputs.push_back(std::move(all));
  }
}

// Waits until all players stand still. Returns false when one does not, or when the round is over.
bool LevelSolver::settle(Situation& situation) const {
  int resting = 0;
  for (int tick = 0; tick < kMaxTicksToRest && resting < kTicksOfRest; ++tick) {
    const std::vector<EntityState> before(situation.game.world().entities().begin(),
                                          situation.game.world().entities().end());
    play(situation, 0, {Input{Input::kPresent}});
    const auto& after = situation.game.world().entities();
    const bool rests = std::equal(before.begin(), before.end(), after.begin(), after.end(),
                                  [](const EntityState& a, const EntityState& b) {
                                    return a.part == b.part && a.position == b.position && a.angle == b.angle;
                                  });
    resting = rests ? resting + 1 : 0;
  }
  return resting == kTicksOfRest && !situation.game.over();
}

std::uint32_t LevelSolver::takenKeys(const Game& game) const {
  std::uint32_t taken = 0;
  for (const Element& element : level_->elements) {
    if (unlocksDoors(element.kind) && game.isTaken(element)) taken |= element.bit();
  }
  return taken;
}

}  // namespace platon
