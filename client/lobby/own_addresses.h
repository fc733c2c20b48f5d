#pragma once

#include <string>
#include <vector>

namespace platon {

/// Addresses at which other machines may reach this one, IPv4 first: without loopback and without addresses that are
/// valid on one link only.
std::vector<std::string> ownAddresses();

}  // namespace platon
