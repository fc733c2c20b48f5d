#include "client/demo/stroll.h"

#include <array>
#include <cstdlib>
#include <vector>

namespace platon {
namespace {

constexpr std::uint32_t kHopTicks = 14;
constexpr std::uint32_t kStepsPerHop = 4;
constexpr std::uint32_t kMaxRests = 3;     // in a row, then the player returns to the start
constexpr std::uint32_t kLostTicks = 300;  // since a step began: the ball falls for ever, and returns, too
constexpr std::int32_t kMinWay = 20 * kSubunitsPerUnit;
constexpr std::int32_t kMaxTickWay = 32 * kSubunitsPerUnit;  // a longer one is a return to the start

bool stands(const Game& game, std::uint32_t slot) { return game.player(slot).ground != Point(); }

// Whether a hazard has sent the player back in the last tick.
bool wasSentBack(const EntityState& before, const EntityState& now) {
  if (before.part != now.part) return before.crossings == now.crossings;
  return std::abs(now.position.x - before.position.x) > kMaxTickWay ||
         std::abs(now.position.y - before.position.y) > kMaxTickWay;
}

}  // namespace

Input Stroll::inputOf(const Step& step, std::uint32_t tick) {
  const bool jumps = step.hops && tick < kHopTicks;
  return {static_cast<std::uint8_t>(Input::kPresent | step.direction | (jumps ? Input::kJump : 0))};
}

// It can end at rest on ground, neither at the goal nor with a return to the start, and is no run against a wall.
bool Stroll::isFine(Game trial, std::uint32_t slot, const Step& step) {
  std::vector<Input> inputs(trial.slots());
  for (std::uint32_t other = 0; other < trial.slots(); ++other)
    inputs[other] = {static_cast<std::uint8_t>(trial.player(other).held & Input::kPresent)};
  const EntityState first = trial.world().entities()[slot];
  for (std::uint32_t tick = 0; tick < kStepTicks + kMaxSettleTicks; ++tick) {
    inputs[slot] = tick < kStepTicks ? inputOf(step, tick) : Input{Input::kPresent};
    const EntityState before = trial.world().entities()[slot];
    trial.advance(inputs);
    const EntityState& now = trial.world().entities()[slot];
    if (wasSentBack(before, now) || trial.player(slot).arrived != 0) return false;
    if (tick < kStepTicks || !stands(trial, slot) || now.position != before.position) continue;
    return now.part != first.part || std::abs(now.position.x - first.position.x) > kMinWay ||
           std::abs(now.position.y - first.position.y) > kMinWay;
  }
  return false;
}

// Rather on than back, and rather as it is the turn of than otherwise.
void Stroll::decide(const Game& game, std::uint32_t slot) {
  ticks_ = 0;
  const bool hopsFirst = ++steps_ % kStepsPerHop == 0;
  const auto back = static_cast<std::uint8_t>(step_.direction ^ Input::kDirections);
  for (const Step& step : std::array{Step{step_.direction, hopsFirst}, Step{step_.direction, !hopsFirst},
                                     Step{back, hopsFirst}, Step{back, !hopsFirst}}) {
    if (!isFine(game, slot, step)) continue;
    step_ = step;
    rests_ = 0;
    return;
  }
  ++rests_;
}

Input Stroll::choose(const Game& game, std::uint32_t slot) {
  if (slot >= game.slots() || game.player(slot).present == 0) return {Input::kPresent};
  if (rests_ > kMaxRests || ticks_ > kLostTicks) {
    *this = {};
    return {Input::kPresent | Input::kRestart};
  }
  if (ticks_ >= kStepTicks && stands(game, slot)) decide(game, slot);
  const std::uint32_t tick = ticks_++;
  return tick < kStepTicks && rests_ == 0 ? inputOf(step_, tick) : Input{Input::kPresent};
}

}  // namespace platon
