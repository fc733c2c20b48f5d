#pragma once

#include "protocol/transport/socket_address.h"

namespace platon {

enum class IpVersion { kIpv4, kIpv6 };

/// Addresses of the attacks, of 127.0.0.0/8 or of fd00::/16. None is exempt from limits.

/// Of the server, which alone is the loopback address.
IpAddress serverAddress(IpVersion version);
/// Of an honest player, from 1. Each has a household of its own.
IpAddress playerAddress(IpVersion version, int number);
/// Of an attacker who answers there. Attacks that need answers use at most this many households.
inline constexpr int kOwnHouseholds = 4;
/// `number` modulo kOwnHouseholds is the household. With IPv6, each household has an address for each number.
IpAddress ownAddress(IpVersion version, int number);
/// In whose name an attacker sends and that never answers, 0 … 9999. With IPv6, 250 of them share 64 bits.
inline constexpr int kStrangers = 10000;
SocketAddress strangerAddress(IpVersion version, int number);

}  // namespace platon
