#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

#include "client/audio/wave.h"

namespace platon {

inline int peakOf(const Pcm& pcm) {
  int peak = 0;
  for (const std::int16_t sample : pcm.samples) peak = std::max(peak, std::abs(int{sample}));
  return peak;
}

/// Mean of a channel, in steps of a sample.
inline double offsetOf(const Pcm& pcm, int channel) {
  double sum = 0;
  for (std::size_t i = 0; i < pcm.frames(); ++i) {
    sum += pcm.samples[i * static_cast<std::size_t>(pcm.channels) + static_cast<std::size_t>(channel)];
  }
  return sum / static_cast<double>(pcm.frames());
}

/// The frequency of a sine whose samples change as much, in the root mean square, from one to the next: hertz.
inline double brightnessOf(const Pcm& pcm) {
  double squares = 0;
  double changes = 0;
  const auto step = static_cast<std::size_t>(pcm.channels);
  for (std::size_t i = step; i < pcm.samples.size(); ++i) {
    squares += double{1} * pcm.samples[i] * pcm.samples[i];
    changes += std::pow(double{1} * pcm.samples[i] - pcm.samples[i - step], 2);
  }
  return std::asin(std::min(1.0, std::sqrt(changes / squares) / 2)) / std::numbers::pi * kSampleRate;
}

/// Whether the step from the last frame to the first is one like all others: neither the value jumps more than from any
/// frame to the next, nor the slope. A constant of 2 allows for rounding.
inline bool hasSeam(const Pcm& pcm) {
  const auto channels = static_cast<std::size_t>(pcm.channels);
  const std::size_t frames = pcm.frames();
  for (std::size_t c = 0; c < channels; ++c) {
    const auto at = [&](std::size_t i) { return int{pcm.samples[(i % frames) * channels + c]}; };
    const auto step = [&](std::size_t i) { return std::abs(at(i + 1) - at(i)); };
    const auto bend = [&](std::size_t i) { return std::abs(at(i + 2) - 2 * at(i + 1) + at(i)); };
    int largestStep = 0;
    int largestBend = 0;
    for (std::size_t i = 0; i + 2 < frames; ++i) {
      largestStep = std::max(largestStep, step(i));
      largestBend = std::max(largestBend, bend(i));
    }
    if (step(frames - 1) > largestStep + 2) return true;
    if (std::max(bend(frames - 2), bend(frames - 1)) > largestBend + 2) return true;
  }
  return false;
}

}  // namespace platon
