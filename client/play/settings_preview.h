#pragma once

#include <cstdint>

#include "client/gl/game_view.h"
#include "client/hud/net_graph.h"
#include "client/play/offscreen/local_game.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/overlay.h"
#include "client/ui/settings.h"
#include "platon/game/game.h"

namespace platon {

/// What is shown while the player changes a setting that can be judged only in motion: a ball that runs over an edge
/// and back, for ever, in a game of its own, with the whole display over it.
class SettingsPreview {
 public:
  static constexpr std::uint32_t kMaxTicks = 15;  ///< of one picture: a late one is not made up for

  SettingsPreview();

  /// Plays on for `seconds` at the game speed of the settings, but at most kMaxTicks.
  void advance(const Settings& settings, double seconds);
  /// Draws the present moment with these settings, `seconds` after the last picture, and a menu in front of it.
  void draw(GameView& view, Settings settings, const KeyHints& keys, const Overlay& menu, double seconds);

  const Game& game() const { return game_.game(); }

 private:
  void begin();
  void tick();
  std::uint32_t face() const;

  LocalGame game_;
  NetGraph netGraph_;
  double due_ = 0;                // ticks to be played
  std::uint32_t home_ = 0;        // the face of the start
  bool away_ = true;              // the ball runs away from this face
  std::uint32_t ticks_ = 0;       // since it has turned round
  std::uint32_t ticksThere_ = 0;  // since it has come to the face to which it runs
};

}  // namespace platon
