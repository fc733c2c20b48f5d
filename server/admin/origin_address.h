#pragma once

#include <cstdint>
#include <optional>

#include "protocol/transport/socket_address.h"

namespace platon {

/// The IP address of an origin, which is the number of a household (`IpAddress::household`): an IPv4 address, or the
/// first address of 64 bits of IPv6. Nothing for 0, which stands for this machine.
std::optional<IpAddress> addressOfOrigin(std::uint64_t origin);

}  // namespace platon
