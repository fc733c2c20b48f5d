#include "client/audio/wave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace platon {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFadeIn = 0.002;  // seconds, of sounds that end
constexpr double kFadeOut = 0.02;

std::size_t framesIn(double seconds) { return static_cast<std::size_t>(std::lround(seconds * kSampleRate)); }

// 0 … 1 along half a cosine.
double eased(double part) {
  if (part >= 1) return 1;
  return part <= 0 ? 0 : 0.5 - 0.5 * std::cos(std::numbers::pi * part);
}

// Envelope of a note: its attack, its decay, and its last tenth.
double envelope(double time, double attack, double decay, double seconds) {
  return eased(time / attack) * std::exp(-time / decay) * eased((seconds - time) / (seconds / 10));
}

// Pseudo-random numbers −1 … 1.
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : state_(seed) {}
  double next() {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8U) / 8388607.5 - 1;
  }

 private:
  std::uint32_t state_;
};

// Two low-pass filters of first order, one after the other.
class LowPass {
 public:
  explicit LowPass(double cutoff) : part_(1 - std::exp(-kTurn * cutoff / kSampleRate)) {}
  double next(double sample) {
    first_ += part_ * (sample - first_);
    second_ += part_ * (first_ - second_);
    return second_;
  }

 private:
  double part_;
  double first_ = 0;
  double second_ = 0;
};

double peakOf(std::span<const double> samples) {
  return std::accumulate(samples.begin(), samples.end(), 0.0,
                         [](double peak, double sample) { return std::max(peak, std::abs(sample)); });
}

double meanOf(std::span<const double> samples) {
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

std::int16_t quantised(double sample) { return static_cast<std::int16_t>(std::lround(sample)); }

// The offset is removed in the shape of one cosine, which keeps both ends at 0.
void removeOffset(std::vector<double>& samples) {
  const double offset = meanOf(samples);
  const double last = static_cast<double>(samples.size() - 1);
  double window = 0;
  const auto shape = [last](std::size_t i) { return 1 - std::cos(kTurn * static_cast<double>(i) / last); };
  for (std::size_t i = 0; i < samples.size(); ++i) window += shape(i);
  const double scale = offset * static_cast<double>(samples.size()) / window;
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] -= scale * shape(i);
}

}  // namespace

Wave::Wave(double seconds, Shape shape) : samples_(framesIn(seconds)), shape_(shape) {}

// Adds next(time) from `start` on, wrapped round in a loop.
template <class Next>
void Wave::addFrom(double start, double seconds, Next&& next) {
  std::size_t at = framesIn(start);
  const std::size_t count = framesIn(seconds);
  if (shape_ == Shape::kLoop) at %= samples_.size();
  for (std::size_t i = 0; i < count; ++i, ++at) {
    if (at >= samples_.size()) {
      if (shape_ == Shape::kOnce) return;
      at = 0;
    }
    samples_[at] += next(static_cast<double>(i) / kSampleRate);
  }
}

void Wave::add(const Tone& tone) {
  const double end = tone.endFrequency > 0 ? tone.endFrequency : tone.frequency;
  const double glide = std::pow(end / tone.frequency, 1 / (tone.seconds * kSampleRate));
  double step = kTurn * tone.frequency / kSampleRate;
  double phase = 0;
  addFrom(tone.start, tone.seconds, [&](double time) {
    const double sample = tone.level * envelope(time, tone.attack, tone.decay, tone.seconds) * std::sin(phase);
    phase += step;
    step *= glide;
    return sample;
  });
}

void Wave::add(const Puff& puff) {
  Noise noise(static_cast<std::uint32_t>(framesIn(puff.start)) + 1);
  LowPass filter(puff.cutoff);
  const double loudness = std::sqrt(kSampleRate / puff.cutoff);  // the filter takes that much away
  addFrom(puff.start, puff.seconds, [&](double time) {
    return puff.level * loudness * envelope(time, puff.attack, puff.decay, puff.seconds) * filter.next(noise.next());
  });
}

// The sine is the imaginary part of a number that turns by a constant angle: much faster than std::sin for long sounds.
void Wave::addSwell(double start, double seconds, double frequency, double level) {
  const double step = kTurn * frequency / kSampleRate;
  const double slow = kTurn / (seconds * kSampleRate);
  double re = 1;
  double im = 0;
  double slowRe = 1;
  double slowIm = 0;
  const auto turn = [](double& x, double& y, double cosine, double sine) {
    const double turned = x * cosine - y * sine;
    y = x * sine + y * cosine;
    x = turned;
  };
  const double cosine = std::cos(step);
  const double sine = std::sin(step);
  const double slowCosine = std::cos(slow);
  const double slowSine = std::sin(slow);
  addFrom(start, seconds, [&](double) {
    const double sample = level * (0.5 - 0.5 * slowRe) * im;
    turn(re, im, cosine, sine);
    turn(slowRe, slowIm, slowCosine, slowSine);
    return sample;
  });
}

// The filter passes over the same noise twice, so that at the start of the second time it is in the state of its end.
void Wave::addBreath(double cutoff, double level, std::uint32_t seed) {
  assert(shape_ == Shape::kLoop);
  LowPass filter(cutoff);
  const double loudness = level * std::sqrt(kSampleRate / cutoff);
  for (const bool heard : {false, true}) {
    Noise noise(seed);
    for (double& sample : samples_) {
      const double filtered = filter.next(noise.next());
      if (heard) sample += loudness * filtered;
    }
  }
}

void Wave::echo(double delay, double gain, int times) {
  const std::vector<double> dry = samples_;
  double level = 1;
  for (int i = 1; i <= times; ++i) {
    level *= gain;
    std::size_t next = 0;
    addFrom(i * delay, static_cast<double>(dry.size()) / kSampleRate, [&](double) { return level * dry[next++]; });
  }
}

void Wave::tremble(int cycles, double depth, double phase) {
  assert(shape_ == Shape::kLoop);
  const double step = kTurn * cycles / static_cast<double>(samples_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    samples_[i] *= 1 - depth * (0.5 + 0.5 * std::sin(step * static_cast<double>(i) + phase));
  }
}

Pcm finishOnce(const Wave& wave, double peak) {
  std::vector<double> samples(wave.samples().begin(), wave.samples().end());
  const double last = static_cast<double>(samples.size() - 1) / kSampleRate;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time = static_cast<double>(i) / kSampleRate;
    samples[i] *= eased(time / kFadeIn) * eased((last - time) / kFadeOut);
  }
  removeOffset(samples);
  const double scale = peak * kMaxSample / peakOf(samples);
  Pcm pcm;
  for (const double sample : samples) pcm.samples.push_back(quantised(sample * scale));
  return pcm;
}

Pcm finishLoop(std::span<const Wave> channels, double peak) {
  Pcm pcm;
  pcm.channels = static_cast<int>(channels.size());
  double loudest = 0;
  std::vector<double> offsets;
  for (const Wave& channel : channels) {
    offsets.push_back(meanOf(channel.samples()));
    loudest = std::max(loudest, peakOf(channel.samples()) + std::abs(offsets.back()));
  }
  const double scale = peak * kMaxSample / loudest;
  for (std::size_t i = 0; i < channels.front().samples().size(); ++i) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      pcm.samples.push_back(quantised((channels[c].samples()[i] - offsets[c]) * scale));
    }
  }
  return pcm;
}

}  // namespace platon
