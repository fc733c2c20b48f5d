#pragma once

#include <cstdint>
#include <cstring>

#include "protocol/transport/socket_address.h"

namespace platon {

/// The origin of an IPv4 address, as HostEvent has it.
inline std::uint32_t originOf(const IpAddress& address) {
  std::uint32_t origin = 0;
  std::memcpy(&origin, &address.bytes[12], sizeof origin);
  return origin;
}

inline std::uint32_t originOf(const char* text) { return originOf(IpAddress::parse(text).value()); }

}  // namespace platon
