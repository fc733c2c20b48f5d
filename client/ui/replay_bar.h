#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// What the bar of a replay shows.
struct ReplayStatus {
  std::uint32_t tick = 0;   ///< recorded ticks that have been played
  std::uint32_t ticks = 0;  ///< of the whole recording
  double speed = 1;
  bool paused = false;
  bool gamepad = false;  ///< its buttons are named instead of keys
  bool several = false;  ///< there are other players to follow
};

/// The position in a replay at the lower edge of a screen of this size, with speed and keys.
Overlay makeReplayBar(const ReplayStatus& status, const Font& font, glm::vec2 screen);

/// The position that a place of the screen chooses: 0 at the start … 1 at the end. Nothing if the place is not
/// on the bar.
std::optional<double> replayBarAt(glm::dvec2 place, glm::vec2 screen);

/// Whether a place of the screen is on the panel of the bar, whose free parts choose nothing.
bool isOnReplayBar(glm::dvec2 place, glm::vec2 screen);

/// As above for a pointer that was pressed on the bar and has been moved: at the sides of the bar, its ends.
double replayBarNear(glm::dvec2 place, glm::vec2 screen);

}  // namespace platon
