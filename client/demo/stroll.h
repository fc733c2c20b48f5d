#pragma once

#include <cstdint>

#include "platon/game/game.h"
#include "platon/game/input.h"

namespace platon {

/// Rolls the ball of a player about, for a picture that is to look alive: along floors and over edges, with a hop now
/// and then, and never where it would fall for long, touch a hazard or reach the goal: it gives no solution away. Each
/// step is tried out on a copy of the game first, in which the others rest. The same game gives the same inputs.
class Stroll {
 public:
  static constexpr std::uint32_t kStepTicks = 40;
  static constexpr std::uint32_t kMaxSettleTicks = 100;  ///< after a step, until the ball must stand again

  /// Input for the next tick of `game`, in which `slot` is a player or will be one.
  Input choose(const Game& game, std::uint32_t slot);

 private:
  struct Step {
    std::uint8_t direction = Input::kRight;
    bool hops = false;
  };

  static Input inputOf(const Step& step, std::uint32_t tick);
  static bool isFine(Game trial, std::uint32_t slot, const Step& step);
  void decide(const Game& game, std::uint32_t slot);

  Step step_;
  std::uint32_t ticks_ = kStepTicks;  // since the step began
  std::uint32_t steps_ = 0;
  std::uint32_t rests_ = 0;  // steps at rest, because none is fine, since the last one
};

}  // namespace platon
