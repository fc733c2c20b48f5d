#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/replay/run_cutter.h"
#include "platon/game/game.h"

namespace platon {

/// A game that a RunCutter follows for one of its players.
class FollowedGame {
 public:
  explicit FollowedGame(std::shared_ptr<const Level> level, std::uint32_t slot = 0) : game(std::move(level)) {
    cutter.begin(game, slot);
  }

  /// Advances by these inputs, by slot.
  void advance(const std::vector<Input>& inputs) {
    game.advance(inputs);
    const std::optional<std::uint32_t> arrival = cutter.advance(inputs, game);
    if (!arrival) return;
    time = arrival;
    run = cutter.cut(game);
  }
  /// Advances with these buttons of slot 0.
  void hold(int ticks, std::uint8_t buttons) {
    for (int i = 0; i < ticks; ++i) advance({{static_cast<std::uint8_t>(buttons | Input::kPresent)}});
  }
  /// Holds the buttons until the goal is reached, at most for `ticks`.
  void holdToGoal(int ticks, std::uint8_t buttons) {
    time.reset();
    for (int i = 0; i < ticks && !time; ++i) hold(1, buttons);
  }

  Game game;
  RunCutter cutter;
  std::optional<std::uint32_t> time;  ///< of the last arrival
  std::optional<Run> run;             ///< cut at the last arrival
};

}  // namespace platon
