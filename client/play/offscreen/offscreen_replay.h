#pragma once

#include <functional>

#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/play/client_options.h"
#include "client/play/replay_play.h"
#include "client/time/clock.h"
#include "client/ui/settings.h"

namespace platon {

/// Draws a moment of a recording without a window.
class OffscreenReplay {
 public:
  /// Reads options.replay, and tells on stderr how far it is if that takes long. Throws ProgramError with one sentence
  /// if it cannot be played, or if `stopRequested` returns true meanwhile, and std::runtime_error if there is no
  /// OpenGL.
  OffscreenReplay(const ClientOptions& options, const Settings& settings, const Clock& clock,
                  const std::function<bool()>& stopRequested);

  /// Draws the moment after the time of the options, or without one the end, and writes it to options.screenshot.
  void run();

  const ReplayViewer& viewer() const { return *replay_.viewer(); }

 private:
  ClientOptions options_;
  Settings settings_;
  ReplayPlay replay_;  // read before there is an OpenGL context: a file that is damaged is named also without OpenGL
  Offscreen offscreen_;
  GameView view_;
};

}  // namespace platon
