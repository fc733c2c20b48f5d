#pragma once

#include <functional>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/lobby/shipped_levels.h"
#include "client/play/client_options.h"
#include "client/play/match/match_play.h"
#include "client/play/play_window.h"
#include "client/time/clock.h"

namespace platon {

/// Plays without a window. Draws the last frame if a screenshot is requested.
class OffscreenPlay {
 public:
  /// Starts to connect. Throws std::runtime_error if connecting cannot start or there is no OpenGL.
  OffscreenPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock);

  /// Plays until the time limit or until `stopRequested` returns true. Throws ProgramError if the match ends earlier.
  void run(const std::function<bool()>& stopRequested);

 private:
  static constexpr double kSeconds = 10;

  void takeScreenshot();

  ClientOptions options_;
  Clock clock_;
  Offscreen offscreen_;
  GameView view_{kPictureWidth, kPictureHeight};
  MatchPlay match_;
  Demo demo_{shippedWay};
};

}  // namespace platon
