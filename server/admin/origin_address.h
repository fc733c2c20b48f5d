#pragma once

#include <cstdint>
#include <optional>

#include "protocol/transport/socket_address.h"

namespace platon {

/// The IP address of an origin as HostEvent has it: the four bytes of an IPv4 address in memory order. Nothing for 0,
/// which stands for this machine.
std::optional<IpAddress> addressOfOrigin(std::uint32_t origin);

}  // namespace platon
