#pragma once

#include <string>

#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// What the head-up display says besides the scene.
struct HudStatus {
  std::string message;   ///< state of the connection, a reason; empty: nothing to say
  bool warning = false;  ///< the message is about something wrong
  bool help = false;     ///< show what the keys do
};

/// `minutes:seconds`, tenths in the last ten seconds. `seconds` ≥ 0.
std::string clockWords(double seconds);

/// What there is to say while there is no game; `width` of the virtual screen.
Overlay makeEmptyHud(const HudStatus& status, const Font& font, float width);

/// Title, clock, players, those who have finished, name tags, message and help.
Overlay makeHud(const Scene& scene, const Camera& camera, const HudStatus& status, const Font& font);

}  // namespace platon
