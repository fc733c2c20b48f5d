#pragma once

#include <cstdint>
#include <string_view>

#include "platon/game/game.h"

namespace platon {

// A recording holds the level text, the rules version, every input of every tick, the hash after every tick, and the
// whole state at checkpoints. It can be replayed from its start or from any checkpoint without further data. Integers
// are little-endian:
//
//   head         magic, rules version u32, length of the level text u32, its complement u32, the text, checksum u64 of
//                all these bytes
//   blocks       length of the body u32, its complement u32, the body, checksum u64 of the body
//     body       first tick u32, ticks u16, slots u16, length of the state u32, the state before the first tick
//                for each slot, runs whose ticks add up to those of the block: ticks u16, buttons u8
//                for each tick, the hash u64 of the game after it
//   end          a block of 0 ticks with the last state

/// First bytes of a recording; the last digit is the version of the format.
inline constexpr std::string_view kRecordingMagic = "PLATREC1";
/// Default number of ticks from one checkpoint to the next.
inline constexpr std::uint32_t kCheckpointTicks = kTicksPerSecond;
/// Largest number of ticks from one checkpoint to the next.
inline constexpr std::uint32_t kMaxCheckpointTicks = 3600;

}  // namespace platon
