#pragma once

#include <cstdint>

namespace platon {

/// Number of a client's connection, by which the host and the match name the client. Numbers are never reused.
using ClientId = std::uint32_t;

}  // namespace platon
