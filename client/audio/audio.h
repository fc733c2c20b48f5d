#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "client/audio/openal_output.h"
#include "client/audio/sounds.h"
#include "platon/game/solid.h"
#include "protocol/work/worker.h"

namespace platon {

/// Volumes that the player has chosen, 0 … 100. 0 is silence.
struct Volumes {
  double all = 100;
  double effects = 100;
  double music = 100;
};

/// Gain of a volume: half the volume sounds about half as loud.
inline double gainOf(double volume) { return volume * volume / 10000; }

/// Gains of the music of each solid over time: that of the present solid fades in while the others fade out, and all
/// are softer for a while after the goal.
class MusicFade {
 public:
  static constexpr double kFadeSeconds = 4;       ///< of a change of solid
  static constexpr double kDuckSeconds = 3;       ///< softest for so long after the goal
  static constexpr double kDuckGain = 0.3;        ///< meanwhile
  static constexpr double kAttackSeconds = 0.3;   ///< to become that soft
  static constexpr double kReleaseSeconds = 2.5;  ///< to become loud again

  /// Advances the time by `seconds`, at least 0. `solid`: whose music is to be heard; nothing: none.
  void advance(std::optional<SolidKind> solid, double seconds);
  /// The local player has reached the goal.
  void duck() { duckLeft_ = kDuckSeconds; }

  /// 0 … 1. The squares of the gains of two solids add up to 1 while one replaces the other, without a duck.
  double gain(SolidKind solid) const;

 private:
  std::array<double, kSolidKinds> parts_{};  // 0: silent … 1: full; linear in time
  double duckLeft_ = 0;
  double duckGain_ = 1;
};

/// Makes the game heard: opens the device, makes the sounds and plays them. The device is opened, and sounds and music
/// are made, in threads of their own, so that no frame waits for them; what is to be heard before is left out. The
/// end waits for the threads: usually not at all, at most until the music of a solid is made, or for Worker::kEndTime.
class Audio {
 public:
  using Open = std::function<std::unique_ptr<OpenalOutput>()>;

  /// `open` is called once, in another thread. If it returns null, that is reported once on standard error and nothing
  /// is heard.
  explicit Audio(Open open = &OpenalOutput::open);
  /// Plays what a frame brings. `seconds` since the last call.
  void update(const SoundFrame& frame, const Volumes& volumes, double seconds);
  /// Plays a sound of the menu.
  void play(Sound sound);

  /// The output once it is open and all sounds are made, until then null.
  OpenalOutput* output() { return ready_ ? ready_->output.get() : nullptr; }

 private:
  struct Ready {
    std::unique_ptr<OpenalOutput> output;
    std::array<OpenalOutput::Buffer, kSounds> sounds{};
    OpenalOutput::Loop roll{};
  };
  struct Music {
    Worker<Pcm> making;
    std::optional<OpenalOutput::Loop> loop;
  };

  static Ready load(const Open& open, const std::stop_token& stop);
  bool isReady();
  void play(const Cue& cue);
  void updateRoll(double speed, double seconds);
  void updateMusic(const SoundFrame& frame, double seconds);
  bool hasMusic(SolidKind solid);
  void takeMusic();

  Worker<Ready> loading_;
  std::optional<Ready> ready_;
  std::array<std::optional<Music>, kSolidKinds> music_;
  MusicFade fade_;
  double roll_ = 0;  // speed that is heard, which follows that of the player
};

}  // namespace platon
