#pragma once

#include <cstdint>
#include <string_view>

#include "platon/game/game.h"

namespace platon {

// A recording is a game as it was played: level text, rules version, every input of every tick, the hash after every
// tick, and the whole state at checkpoints. It needs nothing else to be played again, from its start or from any
// checkpoint. Integers stand with their lowest byte first:
//
//   head         magic, rules version u32, length of the level text u32, its complement u32, the text, check sum u64
//                of all that
//   blocks       length of the body u32, its complement u32, the body, check sum u64 of the body
//     body       first tick u32, ticks u16, slots u16, length of the state u32, the state before the first tick
//                for each slot runs that add up to the ticks: ticks u16, buttons u8
//                for each tick the hash u64 of the game after it
//   the end      a block of 0 ticks with the last state

/// The first bytes; the last digit is the version of the format.
inline constexpr std::string_view kRecordingMagic = "PLATREC1";
/// Ticks from one checkpoint to the next, unless another number is asked for.
inline constexpr std::uint32_t kCheckpointTicks = kTicksPerSecond;
/// The most that a recording may have between two.
inline constexpr std::uint32_t kMaxCheckpointTicks = 3600;

}  // namespace platon
