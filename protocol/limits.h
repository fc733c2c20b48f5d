#pragma once

#include <cstddef>
#include <cstdint>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/level.h"

namespace platon {

/// Changes whenever a message changes its form or meaning. Both sides must have the same.
inline constexpr std::uint32_t kProtocolVersion = 2;
inline constexpr std::uint16_t kDefaultPort = 7777;

/// Transport channels: everything reliable goes over one, so that it arrives in the order in which it was sent.
inline constexpr std::uint8_t kReliableChannel = 0;
inline constexpr std::uint8_t kTickChannel = 1;
inline constexpr std::size_t kChannels = 2;

/// No message is longer, in bytes.
inline constexpr std::size_t kMaxMessageBytes = 8 * 1024;
/// No unreliable message is longer, in bytes, so that a datagram with all its envelopes stays within 1200.
inline constexpr std::size_t kMaxTickMessageBytes = 1160;
/// Bytes of a level text or a state that one message carries.
inline constexpr std::size_t kChunkBytes = 4 * 1024;

inline constexpr std::size_t kMaxStateBytes = 1024 * 1024;
/// Levels of which a client can say that it has them.
inline constexpr std::size_t kMaxLevelsKnown = 8;
/// Players that one message names; with the longest names it is well below `kMaxMessageBytes`.
inline constexpr std::size_t kMaxRosterEntries = 64;
/// Bytes of UTF-8.
inline constexpr std::size_t kMaxNameBytes = 32;
inline constexpr std::size_t kMaxReasonBytes = 200;

/// Inputs in one message of a client: more than 2 s of round trip and 1 s of buffer.
inline constexpr std::uint32_t kMaxInputsPerMessage = 256;
/// Ticks and changes of input in one message of the server. Any one tick fits, and the longest message is below
/// `kMaxTickMessageBytes`: a change takes three bytes instead of two only when it is three ticks after the last one.
inline constexpr std::uint32_t kMaxTicksPerMessage = 240;
inline constexpr std::uint32_t kMaxChangesPerMessage = 512;
/// Slack is reported within plus and minus this, in ticks.
inline constexpr std::int32_t kMaxSlack = 1000;

/// What per-tick messages carry of a state hash. A difference that it hides once shows in a later tick.
constexpr std::uint32_t shortHash(std::uint64_t hash) { return static_cast<std::uint32_t>(hash); }

}  // namespace platon
