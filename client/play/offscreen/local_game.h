#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/netcode/player_watch.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "platon/game/game.h"

namespace platon {

/// A game without a server and a clock, and its scenes. The camera follows the player in slot 0. As in a match, a
/// player who is alone has no time limit.
class LocalGame {
 public:
  /// `names`: of the players, by slot.
  LocalGame(std::shared_ptr<const Level> level, std::vector<std::string> names);

  /// Begins the level anew.
  void begin();
  /// Plays a tick. `inputs`: by slot.
  void advance(std::span<const Input> inputs);
  const Game& game() const { return game_; }
  /// The moment to draw, after the last tick. `ownBall`: the look of the ball of slot 0.
  Scene scene(const BallChoice& ownBall = {}) const;

 private:
  Game game_;
  std::shared_ptr<const StageModel> stage_;
  std::vector<std::string> names_;
  AttemptTime attempt_;  // of slot 0
};

}  // namespace platon
