#pragma once

#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/play/client_options.h"
#include "client/replay/replay_viewer.h"
#include "client/ui/settings.h"

namespace platon {

/// Draws a moment of a recording without a window.
class OffscreenReplay {
 public:
  /// Reads options.replay. Throws ProgramError with one sentence if it cannot be played, and std::runtime_error if
  /// there is no OpenGL.
  OffscreenReplay(const ClientOptions& options, const Settings& settings);

  /// Draws the moment after the time of the options, or without one the end, and writes it to options.screenshot.
  void run();

  const ReplayViewer& viewer() const { return viewer_; }

 private:
  ClientOptions options_;
  Settings settings_;
  ReplayViewer viewer_;
  Offscreen offscreen_;
  GameView view_;
};

}  // namespace platon
