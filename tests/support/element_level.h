#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// The text of a valid level with random segments, most of them elements of every kind, some over edges, and some on
/// top of each other. `solid` counts from 0, in the order of SolidKind.
std::string elementLevel(int solid, std::uint64_t seed);

}  // namespace platon
