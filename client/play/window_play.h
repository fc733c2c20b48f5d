#pragma once

#include <functional>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/window.h"
#include "client/play/client_options.h"
#include "client/play/match_play.h"
#include "client/play/net_meter.h"
#include "client/play/settings_file.h"
#include "client/time/clock.h"
#include "client/ui/menu.h"
#include "client/ui/settings.h"
#include "client/ui/steering.h"

namespace platon {

/// Plays in a window.
class WindowPlay {
 public:
  /// Begins to connect. Throws std::runtime_error when that cannot even begin, and ProgramError when no window can be
  /// opened.
  WindowPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock);

  /// Until the player leaves, the time is over or `stopAsked`. Throws ProgramError when the server cannot be joined. A
  /// match that ends later stays on the screen with the reason.
  void run(const std::function<bool()>& stopAsked);

 private:
  bool goesOn(Moment now) const;
  void takePresses();
  void take(Window::Press press);
  void tellEnding();
  Input choose(const Game& game, std::uint32_t slot);
  void draw(Moment now);
  void takeScreenshot();

  ClientOptions options_;
  Clock clock_;
  SettingsFile settingsFile_;
  Settings settings_;
  Window window_;
  GameView view_;
  MatchPlay match_;
  Menu menu_;
  Steering steering_;
  Demo demo_;
  NetMeter meter_;
  bool help_ = false;
  bool toldEnding_ = false;
  Moment begunAt_;
  Moment drawnAt_;
};

}  // namespace platon
