#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "client/audio/music_fade.h"
#include "client/audio/openal_output.h"
#include "client/audio/sound_frame.h"
#include "client/audio/sounds.h"
#include "client/audio/volumes.h"
#include "protocol/work/worker.h"

namespace platon {

/// Makes the game heard: opens the device, makes the sounds and plays them. The device is opened, and sounds and pads
/// are made, in threads of their own, so that no frame waits for them; what is to be heard before is left out. The
/// end waits for the threads: usually not at all, at most until a pad has been made, or for Worker::kEndTime.
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
  struct Pad {
    Worker<Pcm> making;
    std::optional<OpenalOutput::Loop> loop;
  };

  static Ready load(const Open& open, const std::stop_token& stop);
  bool isReady();
  void play(const Cue& cue);
  void updateRoll(double speed, double seconds);
  void updateMusic(const SoundFrame& frame, double seconds);
  bool hasPad(SolidKind solid);
  void takePads();

  Worker<Ready> loading_;
  std::optional<Ready> ready_;
  std::array<std::optional<Pad>, kSolidKinds> pads_;
  MusicFade fade_;
  double roll_ = 0;  // speed that is heard, which follows that of the player
};

}  // namespace platon
