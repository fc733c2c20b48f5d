#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "client/audio/wave.h"
#include "platon/game/solid.h"

namespace platon {

/// The sounds of the game, except the music. All are in the pentatonic scale on D, as the music is, so that whatever
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
  kFenceDown,  ///< a timed segment opens
  kFenceUp,    ///< it becomes solid
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

/// That a sound is to be played once.
struct Cue {
  Sound sound = Sound::kJump;
  double gain = 1;                      ///< 0 … 1
  double pan = 0;                       ///< −1 left … 1 right
  double pitch = 1;                     ///< factor of the frequency
  std::optional<std::uint32_t> slot{};  ///< the player whose it is; nothing: nobody's
};

/// What is to be heard from one frame of the game to the next.
struct SoundFrame {
  std::vector<Cue> cues{};
  double roll = 0;                   ///< speed of the local player on the ground, 0 … 1: a run
  bool celebrates = false;           ///< the local player has just reached the goal
  std::optional<SolidKind> solid{};  ///< whose music is played; nothing: none
};

}  // namespace platon
