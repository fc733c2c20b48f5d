#pragma once

#include <cstddef>
#include <vector>

#include "tests/exactness/oracle/trace/trace.h"

namespace platon::oracle {

/// I2: largest number of moves of an entity in a step.
constexpr std::size_t kMaxMoves = 64;

/// Number of legs that move the entity. Legs that only rotate, rehome, or add or drop instances do not count.
std::size_t movesOf(const std::vector<TraceLeg>& legs);

}  // namespace platon::oracle
