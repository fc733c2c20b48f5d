#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace platon
