#pragma once

#include <array>
#include <cstdint>

#include "tests/net/support/raw_content.h"

namespace platon {

/// More contents like those of raw_content.h, that no client of ours sends.

/// The first of a million fragments of an unreliable message.
Bytes unreliableFragmentContent(std::uint16_t peer);
/// A hundred pings.
Bytes crowdedContent(std::uint16_t peer);

/// One of each kind of them all, to the connection `peer` or to another one. `number` selects it.
Bytes hostileContent(std::uint16_t peer, std::uint32_t number);
inline constexpr std::uint32_t kHostileContents = 16;

}  // namespace platon
