#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/demo/demo.h"
#include "client/play/offscreen/local_game.h"
#include "client/scene/scene.h"
#include "platon/game/game.h"

namespace platon {

/// The game that a benchmark draws: players who follow each other on the way of the demonstration, without a server
/// and a clock. The camera follows the first. When all have reached the goal, they begin anew.
class BenchmarkGame {
 public:
  static constexpr std::uint32_t kPlayers = 16;

  explicit BenchmarkGame(std::shared_ptr<const Level> level);

  /// Plays this number of ticks.
  void advance(std::uint32_t ticks);
  /// The moment to draw.
  Scene scene() const { return game_.scene(); }

 private:
  static constexpr std::uint32_t kTicksBetween = 12;  // from one player to the next

  void advance();

  LocalGame game_;
  Demo demo_;                  // of the first player
  std::vector<Input> inputs_;  // of the first player, by tick
};

}  // namespace platon
