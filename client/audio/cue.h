#pragma once

#include <cstdint>
#include <optional>

#include "client/audio/sounds.h"

namespace platon {

/// That a sound is to be played once.
struct Cue {
  Sound sound = Sound::kJump;
  double gain = 1;                      ///< 0 … 1
  double pan = 0;                       ///< −1 left … 1 right
  double pitch = 1;                     ///< factor of the frequency
  std::optional<std::uint32_t> slot{};  ///< the player whose it is; nothing: nobody's
};

}  // namespace platon
