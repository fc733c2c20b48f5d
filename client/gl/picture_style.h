#pragma once

#include "client/ui/settings.h"

namespace platon {

/// How the player wants to see the game.
struct PictureStyle {
  bool animated = true;  ///< off: nothing moves but the players
  bool flashes = true;   ///< players and goal flash
  bool highContrast = false;
};

/// The style that the player has chosen.
inline PictureStyle styleOf(const Settings& settings) {
  const bool animated = !settings.comfort.reducedMotion;
  return {animated, animated && settings.flashes, settings.highContrast};
}

}  // namespace platon
