#pragma once

#include <functional>

#include "client/client_options.h"
#include "client/clock.h"
#include "client/demo.h"
#include "client/game_view.h"
#include "client/match_play.h"
#include "client/menu.h"
#include "client/net_meter.h"
#include "client/settings.h"
#include "client/settings_file.h"
#include "client/steering.h"
#include "client/window.h"

namespace platon {

/// Plays in a window.
class WindowPlay {
 public:
  /// Begins to connect. Throws std::runtime_error when that cannot even begin, and ClientError when no window can be
  /// opened.
  WindowPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock);

  /// Until the player leaves, the time is over or `stopAsked`. Throws ClientError when the server cannot be joined. A
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
