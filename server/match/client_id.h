#pragma once

#include <cstdint>

namespace platon {

/// Number of a client's connection. Numbers are never reused.
using ClientId = std::uint32_t;

}  // namespace platon
