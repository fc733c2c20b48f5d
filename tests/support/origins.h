#pragma once

#include <cstdint>

#include "protocol/transport/socket_address.h"

namespace platon {

/// The origin of a client at this address, as the server passes it to `Match::receive`.
inline std::uint64_t originOf(const char* text) { return IpAddress::parse(text).value().household(); }

}  // namespace platon
