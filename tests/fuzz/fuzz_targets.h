#pragma once

#include <cstdint>
#include <span>
#include <string>

/// What is fuzzed. Each target makes its input of any bytes, hands it to the code under test and judges what comes out;
/// it returns what is wrong, in words, or an empty text.
namespace platon::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A shape, a displacement and a line: `Sweep` against two evaluations that share nothing with it.
std::string sweepFault(Bytes bytes);
/// A shape among lines, on the plane or on a solid, for some ticks: every leg of the world against the laws I1, I2, I5
/// and I6, contacts in pairs, and a world restored from a saved state in step with the first.
std::string sceneFault(Bytes bytes);
/// A level text: refused with a reason, or everything that `Level` promises.
std::string levelFault(Bytes bytes);
/// A saved game, perhaps forged: refused and without effect, or a game that goes on.
std::string gameStateFault(Bytes bytes);
/// A recording, sound or forged: read to its end or refused, and nothing read that no game could have played.
std::string recordingFault(Bytes bytes);
/// A message from the network: refused, or the same again when encoded and decoded.
std::string protocolFault(Bytes bytes);

}  // namespace platon::fuzz
