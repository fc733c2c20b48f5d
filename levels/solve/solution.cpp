#include "levels/solve/solution.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>

#include "levels/solve/jump_slack.h"
#include "levels/solve/uses.h"

namespace platon {
namespace {

class Replay {
 public:
  Replay(const std::shared_ptr<const Level>& level, std::size_t slots) : game_(level), faces_(slots), held_(slots) {}

  void advance(const std::vector<Input>& inputs) {
    game_.advance(inputs);
    for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) {
      notePresses(slot, inputs[slot]);
      noteFace(slot);
      noteElements(slot);
    }
  }

  const Game& game() const { return game_; }
  SolutionFacts facts() {
    std::uint32_t started = game_.tick();
    facts_.crossings = UINT32_MAX;
    for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) {
      started = std::min(started, game_.player(slot).startedAt);
      facts_.crossings = std::min(facts_.crossings, game_.world().entities()[slot].crossings);
    }
    facts_.ticks = game_.tick() - started + 1;
    return facts_;
  }

 private:
  void notePresses(std::uint32_t slot, Input input) {
    const int pressed = input.buttons & ~held_[slot] & Input::kMoves;
    facts_.presses += static_cast<std::uint32_t>(std::popcount(static_cast<unsigned>(pressed)));
    held_[slot] = input.buttons;
  }
  void noteFace(std::uint32_t slot) {
    const EntityState& entity = game_.world().entities()[slot];
    const auto [known, isNew] = faces_[slot].emplace(entity.part, entity.angle);
    if (isNew || known->second == entity.angle) return;
    known->second = entity.angle;
    ++facts_.turns;
  }
  void noteElements(std::uint32_t slot) {
    const std::vector<Element>& elements = game_.level().elements;
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      if (uses(game_, slot, elements[i])) facts_.elements.insert(i);
    }
  }

  Game game_;
  std::vector<std::map<std::uint32_t, Angle>> faces_;  // up of the last visit, by slot and face
  std::vector<std::uint8_t> held_;
  SolutionFacts facts_;
};

}  // namespace

int difficultyOf(const SolutionFacts& facts) {
  constexpr int kEasyJump = 12;  // a fifth of a second
  const int hurry = facts.slack ? std::max(0, kEasyJump - *facts.slack) : 0;
  return static_cast<int>(facts.presses + 4 * facts.turns) + hurry;
}

std::optional<SolutionFacts> factsOf(const std::shared_ptr<const Level>& level, const Solution& solution) {
  if (solution.empty()) return std::nullopt;
  Replay replay(level, solution.front().size());
  for (const std::vector<Input>& inputs : solution) {
    if (replay.game().over() || inputs.size() != solution.front().size()) return std::nullopt;
    replay.advance(inputs);
  }
  for (std::uint32_t slot = 0; slot < replay.game().slots(); ++slot) {
    if (!replay.game().player(slot).finished()) return std::nullopt;
  }
  SolutionFacts facts = replay.facts();
  facts.slack = tightestJump(level, solution);
  return facts;
}

}  // namespace platon
