#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace platon {

/// The round trip between the server and a player in one byte: kNoRoundTrip for none, else one more than the number of
/// kRoundTripStepMs, rounded. The highest code stands for every longer one.
inline constexpr std::uint8_t kNoRoundTrip = 0;
inline constexpr std::uint32_t kRoundTripStepMs = 4;
inline constexpr std::uint32_t kMaxRoundTripMs = 254 * kRoundTripStepMs;

constexpr std::uint8_t codeOfRoundTrip(std::uint32_t ms) {
  const std::uint32_t steps = (std::min(ms, kMaxRoundTripMs) + kRoundTripStepMs / 2) / kRoundTripStepMs;
  return static_cast<std::uint8_t>(1 + steps);
}

/// Milliseconds, at most kMaxRoundTripMs.
constexpr std::optional<std::uint32_t> roundTripOf(std::uint8_t code) {
  return code == kNoRoundTrip ? std::nullopt : std::optional((code - 1U) * kRoundTripStepMs);
}

}  // namespace platon
