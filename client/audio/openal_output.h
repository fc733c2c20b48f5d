#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "client/audio/wave.h"

namespace platon {

/// Plays sounds through OpenAL. At most one of them exists at a time in a process. OpenAL mixes in a thread of its own;
/// no function waits for it.
class OpenalOutput {
 public:
  /// Whose gain is changed together.
  enum class Group : std::uint8_t { kEffects, kMusic };
  struct Buffer {
    std::uint32_t name = 0;
  };
  struct Loop {
    std::size_t source = 0;
  };

  static constexpr std::size_t kSources = 32;  ///< sounds that can be heard at once …
  static constexpr std::size_t kMaxLoops = 8;  ///< … of which so many are kept for loops
  static constexpr double kHeadroom = 0.8;     ///< factor of all gains, so that many sounds together do not clip

  /// Opens the default device; null if there is none, or none can be opened. Takes up to some hundred milliseconds.
  static std::unique_ptr<OpenalOutput> open();
  /// Opens a device that `render` plays on, without a sound card.
  static std::unique_ptr<OpenalOutput> openLoopback();
  ~OpenalOutput();
  OpenalOutput(const OpenalOutput&) = delete;
  OpenalOutput& operator=(const OpenalOutput&) = delete;

  /// Copies a sound. The buffer exists as long as the output.
  Buffer addBuffer(const Pcm& pcm);
  /// Plays a mono sound once: `gain` 0 … 1, `pan` −1 left … 1 right, `pitch` a factor of the frequency, more than 0.
  /// Without a free source, the sound is left out.
  void play(Buffer buffer, double gain, double pan, double pitch);
  /// Starts to repeat a sound, silently at first. At most kMaxLoops times.
  Loop startLoop(Buffer buffer, Group group);
  void setLoop(Loop loop, double gain, double pitch);

  /// Gain of all sounds, and of those of a group: 0 … 1. They change at once, also of what sounds already.
  void setGain(double gain);
  void setGain(Group group, double gain);

  /// Sources that sound now, silent loops included.
  std::size_t sounding() const;
  /// The next `frames` frames of a loopback device at kSampleRate: left and right interleaved, full scale is 1.
  std::vector<float> render(std::size_t frames);

 private:
  struct Source {
    std::uint32_t name = 0;
    double gain = 0;  // without that of its group
    Group group = Group::kEffects;
  };

  OpenalOutput(void* device, void* context);
  void apply(const Source& source) const;

  void* device_;   // ALCdevice
  void* context_;  // ALCcontext
  std::vector<std::uint32_t> buffers_;
  std::array<Source, kSources> sources_;  // the last kMaxLoops are for loops
  std::size_t loops_ = 0;
  std::array<double, 2> groupGains_{1, 1};
};

}  // namespace platon
