#pragma once

#include <cstdint>

namespace platon {

/// A connection of a client, never used twice.
using ClientId = std::uint32_t;

}  // namespace platon
