#pragma once

#include <memory>

#include "client/netcode/player_watch.h"
#include "client/scene/scene.h"
#include "platon/game/game.h"

namespace platon {

/// One player on a level, on this machine alone: the real game, without a server.
class BallPlay {
 public:
  explicit BallPlay(std::shared_ptr<const Level> level);

  /// Plays one tick.
  void tick(Input input);
  /// The moment `fraction` of a tick after the last but one, 0 … 1.
  Scene scene(double fraction) const;

  const Game& game() const { return game_; }
  const std::shared_ptr<const Level>& level() const { return game_.sharedLevel(); }

 private:
  Game game_;
  std::shared_ptr<const StageModel> stage_;
  PlayerSnapshot before_;
  AttemptTime attempt_;
};

}  // namespace platon
