#pragma once

#include <array>
#include <cstdint>

#include "client/audio/pcm.h"

namespace platon {

/// The sounds of the game, except the pads. All are in the pentatonic scale on D, as the pads are, so that whatever
/// sounds together fits.
enum class Sound : std::uint8_t {
  kRoll,  ///< a loop; the others end
  kJump,
  kLand,
  kEdge,
  kGoal,
  kKey,
  kDoorOpens,
  kDoorCloses,
  kPlateDown,
  kPlateUp,
  kHazard,
  kCheckpoint,
  kRestart,
  kMenuMove,
  kMenuChoose,
  kCountdown,
  kRoundStart,
};

inline constexpr std::size_t kSounds = 17;
/// Every sound, in order.
inline constexpr std::array<Sound, kSounds> kAllSounds = [] {
  std::array<Sound, kSounds> all{};
  for (std::size_t i = 0; i < kSounds; ++i) all[i] = static_cast<Sound>(i);
  return all;
}();

/// Frequency of a step of the pentatonic scale, hertz: step 0 is the D below the standard A, step 5 the D above.
double pentatonic(int step);

/// Makes the samples, mono. Always the same ones.
Pcm makeSound(Sound sound);

}  // namespace platon
