#pragma once

#include <cstdint>
#include <memory>

#include "client/netcode/player_watch.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/controls/input_mapper.h"
#include "client/ui/key.h"
#include "platon/game/game.h"

namespace platon {

/// One player on a level, on this machine alone: the real game, without a server, played with the keys and followed by
/// a camera.
class BallPlay {
 public:
  /// `camera` is where the camera begins.
  BallPlay(std::shared_ptr<const Level> level, const Camera& camera);

  void resize(std::uint32_t w, std::uint32_t h) { camera_.resize(w, h); }
  /// `menuOpen`: presses are not for the ball.
  void handle(const KeyEvent& event, bool menuOpen) { mapper_.handle(event, menuOpen); }
  /// Lets `seconds` pass. `menuOpen`: nothing is pressed meanwhile.
  void advance(double seconds, bool menuOpen);

  /// The present moment, between the last two ticks.
  Scene scene() const;
  const Camera& camera() const { return camera_; }
  const Game& game() const { return game_; }
  const std::shared_ptr<const Level>& level() const { return game_.sharedLevel(); }

 private:
  void tick(Input input);

  Game game_;
  std::shared_ptr<const StageModel> stage_;
  PlayerSnapshot before_;
  AttemptTime attempt_;
  EndlessFall fall_;
  Camera camera_;
  InputMapper mapper_;
  Steering steering_;
  double untilTick_ = 0;  // seconds since the last tick
};

}  // namespace platon
