#pragma once

#include <functional>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/play/client_options.h"
#include "client/play/match_play.h"
#include "client/time/clock.h"

namespace platon {

/// Plays without a window, and draws the last moment when a screenshot is wanted.
class OffscreenPlay {
 public:
  /// Begins to connect. Throws std::runtime_error when that cannot even begin, or when there is no OpenGL.
  OffscreenPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock);

  /// Until the time is over or `stopAsked`. Throws ProgramError when the match ends before.
  void run(const std::function<bool()>& stopAsked);

 private:
  static constexpr double kSeconds = 10;
  static constexpr std::uint32_t kWidth = 1280;
  static constexpr std::uint32_t kHeight = 720;

  void takeScreenshot();

  ClientOptions options_;
  Clock clock_;
  Offscreen offscreen_;
  GameView view_{kWidth, kHeight};
  MatchPlay match_;
  Demo demo_;
};

}  // namespace platon
