#pragma once

#include <functional>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/window.h"
#include "client/play/client_options.h"
#include "client/play/match_play.h"
#include "client/play/net_meter.h"
#include "client/play/settings_file.h"
#include "client/play/sound_feed.h"
#include "client/play/user_folders.h"
#include "client/time/clock.h"
#include "client/ui/steering.h"
#include "client/ui/user_interface.h"

namespace platon {

/// Plays in a window.
class WindowPlay {
 public:
  /// Starts to connect. Throws std::runtime_error if connecting cannot start, and ProgramError if no window can be
  /// opened.
  WindowPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock);

  /// Plays until the player leaves, the time limit of the options is reached or `stopRequested` returns true. Throws
  /// ProgramError when the server cannot be joined. When a match ends later, its last picture stays on the screen with
  /// the reason.
  void run(const std::function<bool()>& stopRequested);

 private:
  bool shouldContinue(Moment now) const;
  void handleKeys();
  void reportEnding();
  Input choose(const Game& game, std::uint32_t slot);
  void draw(Moment now);
  void playSounds(const Scene* scene, const HudStatus& status, double seconds);
  void takeScreenshot();

  ClientOptions options_;
  Clock clock_;
  SettingsFile settingsFile_{configFolder()};
  UserInterface interface_;
  Window window_;
  GameView view_;
  MatchPlay match_;
  Steering steering_;
  Demo demo_;
  NetMeter meter_;
  SoundFeed sound_;
  bool endingReported_ = false;
  Moment startedAt_;
  Moment drawnAt_;
};

}  // namespace platon
