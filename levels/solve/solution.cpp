#include "levels/solve/solution.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>

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

constexpr int kLandingTicks = 30;                           // a shifted jump may land this much later
constexpr std::int32_t kSameHeight = 3 * kSubunitsPerUnit;  // as where the jump of the solution landed

// Where a player has landed: on a face, at a height along its up.
struct Landing {
  std::uint32_t face = 0;
  Angle up;
  std::int32_t height = 0;

  static std::optional<Landing> of(const Game& game, std::uint32_t slot) {
    if (game.player(slot).ground == Point() && game.player(slot).arrived == 0) return std::nullopt;
    const EntityState& entity = game.world().entities()[slot];
    return Landing{entity.part, entity.angle, rotate(entity.position, -entity.angle).y};
  }
  bool isAt(const Landing& other) const {
    return face == other.face && up == other.up && std::abs(height - other.height) <= kSameHeight;
  }
};

class JumpSlack {
 public:
  JumpSlack(const std::shared_ptr<const Level>& level, const Solution& solution) : solution_(solution) {
    Game game(level);
    games_.push_back(game);
    for (const std::vector<Input>& inputs : solution) {
      game.advance(inputs);
      games_.push_back(game);
    }
  }

  // Nothing when no jump starts in this tick, or when it never lands.
  std::optional<int> of(std::size_t tick, std::uint32_t slot) const {
    if (!startsJump(tick, slot)) return std::nullopt;
    const auto landed = landingAfter(tick, slot);
    if (!landed) return std::nullopt;
    const Landing aim = *Landing::of(games_[*landed], slot);
    int slack = 1;
    for (const int way : {-1, 1}) {
      for (int shift = 1; shift <= kMaxJumpSlack && lands(tick, *landed - tick, slot, way * shift, aim); ++shift)
        ++slack;
    }
    return slack;
  }

 private:
  bool startsJump(std::size_t tick, std::uint32_t slot) const {
    if (slot >= games_[tick].slots()) return false;
    const PlayerState& before = games_[tick].player(slot);
    const PlayerState& after = games_[tick + 1].player(slot);
    return after.jumping != 0 && (before.jumping == 0 || after.velocity.y > before.velocity.y);
  }
  // The number of ticks after which the player stands again.
  std::optional<std::size_t> landingAfter(std::size_t tick, std::uint32_t slot) const {
    for (std::size_t at = tick + 1; at < games_.size(); ++at) {
      if (Landing::of(games_[at], slot)) return at;
    }
    return std::nullopt;
  }
  // Whether the jump lands there when it starts `shift` ticks later, or earlier if negative.
  bool lands(std::size_t tick, std::size_t flight, std::uint32_t slot, int shift, const Landing& aim) const {
    const auto first = static_cast<std::ptrdiff_t>(tick) + std::min(shift, 0);
    if (first < 1) return false;
    Game game = games_[static_cast<std::size_t>(first)];
    const Input before = solution_[static_cast<std::size_t>(first) - 1][slot];
    const auto play = [&](Input input, std::size_t at) {
      std::vector<Input> inputs = solution_[std::min(at, solution_.size() - 1)];
      inputs[slot] = input;
      game.advance(inputs);
    };
    std::size_t now = static_cast<std::size_t>(first);
    const Input waiting{static_cast<std::uint8_t>(before.buttons & ~Input::kJump)};
    for (int late = 0; late < shift; ++late) play(waiting, now++);
    for (std::size_t i = 0; i < flight + kLandingTicks; ++i) {
      const std::size_t at = std::min(tick + std::min(i, flight - 1), solution_.size() - 1);
      play(solution_[at][slot], now++);
      if (game.player(slot).arrived != 0) return true;
      if (i > 3 && game.player(slot).ground != Point()) return Landing::of(game, slot)->isAt(aim);
    }
    return false;
  }

  const Solution& solution_;
  std::vector<Game> games_;  // after 0, 1 … ticks
};

}  // namespace

std::optional<int> tightestJump(const std::shared_ptr<const Level>& level, const Solution& solution) {
  const JumpSlack slack(level, solution);
  std::optional<int> tightest;
  for (std::size_t tick = 0; tick < solution.size(); ++tick) {
    for (std::uint32_t slot = 0; slot < solution[tick].size(); ++slot) {
      const auto jump = slack.of(tick, slot);
      if (jump) tightest = std::min(tightest.value_or(*jump), *jump);
    }
  }
  return tightest;
}

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
