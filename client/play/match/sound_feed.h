#pragma once

#include <optional>
#include <utility>

#include "client/audio/audio.h"
#include "client/audio/sound_cues.h"
#include "client/menu/menu.h"
#include "client/scene/scene.h"
#include "client/session/session.h"
#include "client/ui/settings.h"

namespace platon {

/// Makes a session and the menu heard.
class SoundFeed {
 public:
  explicit SoundFeed(Audio::Open open = &OpenalOutput::open) : audio_(std::move(open)) {}

  /// Plays what the menu has done since the last frame.
  void menu(Menu::Deed deed);
  /// Plays what a frame brings, `seconds` after the last one. `session` and `scene`: null while there is none, also
  /// during an outage. `nextRoundSeconds`: until the next round starts, if that is known.
  void update(const Session* session, const Scene* scene, std::optional<double> nextRoundSeconds,
              const Settings& settings, double seconds);

  Audio& audio() { return audio_; }

 private:
  Audio audio_;
  SoundCues cues_;
};

}  // namespace platon
