#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace platon {

/// Sample rate of every sound, frames per second.
inline constexpr int kSampleRate = 48000;
/// Largest magnitude of a sample of any sound: −3 dBFS.
inline constexpr std::int16_t kMaxSample = 23197;

/// A sound as samples.
struct Pcm {
  int channels = 1;                   ///< 1, or 2: left and right
  std::vector<std::int16_t> samples;  ///< interleaved

  std::size_t frames() const { return samples.size() / static_cast<std::size_t>(channels); }
};

/// A decaying sine, optionally gliding. Seconds and hertz.
struct Tone {
  double start = 0;
  double frequency = 440;
  double endFrequency = 0;  ///< reached exponentially over `seconds`; 0: the frequency stays
  double level = 1;
  double attack = 0.005;  ///< rises from 0 along half a cosine
  double decay = 0.2;     ///< time in which it falls to 1/e
  double seconds = 1;     ///< duration; the last tenth fades out
};

/// A puff of low-pass filtered noise. Seconds and hertz.
struct Puff {
  double start = 0;
  double cutoff = 800;
  double level = 1;
  double attack = 0.01;
  double decay = 0.1;
  double seconds = 0.5;
};

/// One channel of a sound while it is made. What reaches beyond the end of a loop continues at its beginning; of other
/// sounds it is cut off. The same calls give the same samples: the noise is pseudo-random.
class Wave {
 public:
  enum class Shape : std::uint8_t { kOnce, kLoop };

  Wave(double seconds, Shape shape);

  void add(const Tone& tone);
  void add(const Puff& puff);
  /// A sine that rises and falls along a cosine over its whole duration, for music.
  void addSwell(double start, double seconds, double frequency, double level);
  /// Noise of constant loudness that has no seam. Only for loops. `seed` selects the noise.
  void addBreath(double cutoff, double level, std::uint32_t seed);
  /// Adds what is there again `times` times, each time `delay` seconds later and `gain` times as loud.
  void echo(double delay, double gain, int times);
  /// Multiplies by 1 − depth … 1, in `cycles` whole periods over the wave. Only for loops.
  void tremble(int cycles, double depth, double phase);

  std::span<const double> samples() const { return samples_; }

 private:
  template <class Next>
  void addFrom(double start, double seconds, Next&& next);

  std::vector<double> samples_;
  Shape shape_;
};

/// Makes the samples of a sound that ends: removes the offset, fades both ends to 0, and scales the peak to `peak`, a
/// part of kMaxSample, 0 … 1.
Pcm finishOnce(const Wave& wave, double peak);
/// Makes the samples of a loop of one or two channels of equal length: removes the offset and scales the peak.
Pcm finishLoop(std::span<const Wave> channels, double peak);

}  // namespace platon
