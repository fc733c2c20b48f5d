#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "client/demo/demo.h"
#include "client/lobby/shipped_levels.h"
#include "client/netcode/prediction.h"
#include "client/play/offscreen/local_game.h"
#include "client/scene/scene.h"
#include "platon/game/game.h"

namespace platon {

/// The game that a benchmark draws: players who follow each other on the way of the demonstration, without a server
/// and a clock. The camera follows the first. When all have reached the goal, they begin anew.
class BenchmarkGame {
 public:
  static constexpr std::uint32_t kPlayers = 16;

  static constexpr std::uint32_t kLead = 6;  ///< of the prediction: ticks, a round trip of 100 ms

  explicit BenchmarkGame(std::shared_ptr<const Level> level);

  /// Plays this number of ticks.
  void advance(std::uint32_t ticks);
  /// Does what a client does in the next tick that was played and not predicted yet: takes the inputs of all players of
  /// kLead ticks before, reconciles, and predicts the tick with the input of the first player. Nothing is left to do
  /// after as many calls as ticks.
  void predict();
  /// What `predict` has made of this round.
  const Prediction& prediction() const { return *prediction_; }
  /// The moment to draw.
  Scene scene() const { return game_.scene(); }

 private:
  static constexpr std::uint32_t kTicksBetween = 12;  // from one player to the next

  void begin();
  void advance();

  LocalGame game_;
  Demo demo_{shippedWay};                   // of the first player
  std::vector<std::vector<Input>> inputs_;  // of the round, by tick and slot
  std::optional<Prediction> prediction_;    // of the round; always set
};

}  // namespace platon
