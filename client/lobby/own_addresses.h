#pragma once

#include <string>
#include <vector>

#include "protocol/transport/socket_address.h"

namespace platon {

/// Addresses at which other machines may reach this one, IPv4 first: without loopback and without addresses that are
/// valid on one link only.
std::vector<std::string> ownAddresses();

/// Addresses that all machines of an IPv4 network receive, of each network that this machine is in.
std::vector<IpAddress> broadcastAddresses();

}  // namespace platon
