#pragma once

namespace platon {

/// How the player wants to see the game.
struct PictureStyle {
  bool animated = true;  ///< off: nothing moves but the players
  bool flashes = true;   ///< players and goal flash
  bool highContrast = false;
};

}  // namespace platon
