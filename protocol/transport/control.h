#pragma once

#include <array>
#include <cstdint>

#include "protocol/transport/noise.h"

namespace platon {

/// Content of a sealed datagram for the transport itself: one of these bytes, then a challenge.
inline constexpr std::uint8_t kPathChallenge = 1;  ///< server: shows whether the client receives at its new address
inline constexpr std::uint8_t kPathResponse = 2;   ///< client: the challenge it has received

using PathChallenge = std::array<std::uint8_t, 8>;

/// Bytes of the datagram with a challenge.
inline constexpr std::size_t kPathChallengeBytes = 2 + 1 + sizeof(PathChallenge) + kTagBytes;

}  // namespace platon
