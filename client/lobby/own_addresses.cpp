#include "client/lobby/own_addresses.h"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>

namespace platon {
namespace {

IpAddress ipv4Of(const sockaddr& address) {
  sockaddr_in ipv4{};
  std::memcpy(&ipv4, &address, sizeof ipv4);
  std::array<std::uint8_t, 4> bytes{};
  std::memcpy(bytes.data(), &ipv4.sin_addr, bytes.size());
  return IpAddress::ofIpv4(bytes);
}

std::optional<IpAddress> addressOf(const ifaddrs& each) {
  if (each.ifa_addr == nullptr || (each.ifa_flags & IFF_UP) == 0 || (each.ifa_flags & IFF_LOOPBACK) != 0) return {};
  if (each.ifa_addr->sa_family == AF_INET) return ipv4Of(*each.ifa_addr);
  if (each.ifa_addr->sa_family != AF_INET6) return {};
  sockaddr_in6 ipv6{};
  std::memcpy(&ipv6, each.ifa_addr, sizeof ipv6);
  if (IN6_IS_ADDR_LINKLOCAL(&ipv6.sin6_addr)) return {};
  IpAddress address;
  std::memcpy(address.bytes.data(), &ipv6.sin6_addr, address.bytes.size());
  return address;
}

// Loopback has no broadcast address here: the flag is missing, and another machine cannot be reached by it.
std::optional<IpAddress> broadcastOf(const ifaddrs& each) {
  if (each.ifa_addr == nullptr || each.ifa_addr->sa_family != AF_INET || each.ifa_broadaddr == nullptr) return {};
  if ((each.ifa_flags & IFF_UP) == 0 || (each.ifa_flags & IFF_BROADCAST) == 0) return {};
  return ipv4Of(*each.ifa_broadaddr);
}

// What `find` says of each address of each network interface, where it says something.
template <class Find>
std::vector<IpAddress> allOf(Find find) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> all(first, freeifaddrs);
  std::vector<IpAddress> found;
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    if (const std::optional<IpAddress> address = find(*each)) found.push_back(*address);
  }
  return found;
}

}  // namespace

std::vector<std::string> ownAddresses() {
  std::vector<IpAddress> found = allOf(addressOf);
  std::stable_partition(found.begin(), found.end(), [](const IpAddress& address) { return address.isIpv4(); });
  std::vector<std::string> texts;
  for (const IpAddress& address : found) texts.push_back(address.text());
  return texts;
}

std::vector<IpAddress> broadcastAddresses() { return allOf(broadcastOf); }

}  // namespace platon
