#pragma once

#include <string>
#include <string_view>

#include "client/scene/camera.h"
#include "client/ui/steering.h"

namespace platon {

/// What a player may choose; all of it at any time.
struct Settings {
  CameraComfort comfort;
  ControlFrame controls = ControlFrame::kPlayer;
  double zoom = 1;  ///< 0.5 … 2
  bool fullscreen = false;
  bool netGraph = false;

  /// As lines `name value`, which `parseSettings` reads.
  std::string text() const;
};

struct SettingsResult {
  Settings settings;  ///< with the usual value for what the text does not name
  std::string error;  ///< empty, or what is wrong with the first bad line and how to mend it
};

SettingsResult parseSettings(std::string_view text);

}  // namespace platon
