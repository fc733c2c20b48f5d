#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/gl/window.h"
#include "client/play/client_options.h"
#include "client/replay/replay_viewer.h"
#include "client/time/clock.h"
#include "client/ui/settings.h"

namespace platon {

/// Reads a recording. Throws ProgramError with one sentence if it cannot be played.
std::shared_ptr<const Replay> loadReplay(const std::filesystem::path& file);

/// Shows a recording in a window, or with options.offscreen draws its last picture.
class ReplayPlay {
 public:
  /// Plays options.replay. Throws ProgramError if it cannot be played, or if no window can be opened.
  ReplayPlay(const ClientOptions& options, const Settings& settings, const Clock& clock);

  /// Shows it until the user leaves, the time limit of the options is reached or `stopRequested` returns true.
  /// Off-screen, the time limit is the time of the recording that is drawn; without one, its end is.
  void run(const std::function<bool()>& stopRequested);

  const ReplayViewer& viewer() const { return viewer_; }

 private:
  void runWindow(const std::function<bool()>& stopRequested);
  bool timeIsLeft(Moment now) const;
  void handleEvents();
  void draw(double seconds);
  void takeScreenshot();

  ClientOptions options_;
  Settings settings_;
  Clock clock_;
  ReplayViewer viewer_;
  std::optional<Window> window_;  // one of these two
  std::optional<Offscreen> offscreen_;
  GameView view_;
  Moment startedAt_;
};

}  // namespace platon
