#include "protocol/transport/socket_address.h"

#include <arpa/inet.h>

#include <algorithm>
#include <cassert>
#include <cstring>

namespace platon {
namespace {

constexpr std::size_t kIpv4Offset = 12;  // of an IPv4 address within its IPv6 form
constexpr std::array<std::uint8_t, kIpv4Offset> kIpv4Prefix = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
constexpr std::array<std::uint8_t, kIpv4Offset> kTranslatedPrefix = {0, 0x64, 0xff, 0x9b};
constexpr std::size_t kHouseholdBytes = 8;
constexpr std::uint64_t kLoopbackNetwork = 0;
// Of the other addresses whose network would have that number. They are reserved, as is the network with this number.
constexpr std::uint64_t kZeroNetwork = 0x0000'fffe'0000'0000;

// fe80::/10
bool isLinkLocal(const std::array<std::uint8_t, 16>& bytes) { return bytes[0] == 0xfe && (bytes[1] & 0xc0) == 0x80; }

}  // namespace

std::optional<IpAddress> IpAddress::parse(std::string_view text) {
  const std::string terminated(text);
  IpAddress address;
  if (inet_pton(AF_INET6, terminated.c_str(), address.bytes.data()) == 1) return address;
  std::array<std::uint8_t, 4> ipv4{};
  if (inet_pton(AF_INET, terminated.c_str(), ipv4.data()) == 1) return ofIpv4(ipv4);
  return std::nullopt;
}

IpAddress IpAddress::ofIpv4(const std::array<std::uint8_t, 4>& bytes) {
  IpAddress address;
  const auto end = std::copy(kIpv4Prefix.begin(), kIpv4Prefix.end(), address.bytes.begin());
  std::copy(bytes.begin(), bytes.end(), end);
  return address;
}

std::array<std::uint8_t, 4> IpAddress::ipv4() const {
  assert(isIpv4());
  return {bytes[kIpv4Offset], bytes[kIpv4Offset + 1], bytes[kIpv4Offset + 2], bytes[kIpv4Offset + 3]};
}

bool IpAddress::isIpv4() const { return std::equal(kIpv4Prefix.begin(), kIpv4Prefix.end(), bytes.begin()); }

bool IpAddress::holdsIpv4() const {
  return isIpv4() || std::equal(kTranslatedPrefix.begin(), kTranslatedPrefix.end(), bytes.begin());
}

bool IpAddress::isLoopback() const {
  IpAddress ipv6;
  ipv6.bytes.back() = 1;
  return *this == ipv6 || *this == ofIpv4({127, 0, 0, 1});
}

bool IpAddress::isThisMachine() const { return isLoopback() || (isIpv4() && ipv4()[0] == 127); }

bool IpAddress::isPrivate() const {
  if (!holdsIpv4()) return isLoopback() || *this == IpAddress{} || (bytes[0] & 0xfe) == 0xfc || isLinkLocal(bytes);
  const std::uint8_t first = bytes[kIpv4Offset];
  const std::uint8_t second = bytes[kIpv4Offset + 1];
  return first == 0 || first == 10 || first == 127 || (first == 100 && (second & 0xc0) == 64) ||
         (first == 169 && second == 254) || (first == 172 && (second & 0xf0) == 16) || (first == 192 && second == 168);
}

// The prefix of an IPv4 address is 0:ffff, which no network has as the first half of its IPv6 addresses.
std::uint64_t IpAddress::household() const {
  if (isLoopback()) return kLoopbackNetwork;
  std::uint64_t number = holdsIpv4() ? 0xffff : 0;
  const std::size_t first = holdsIpv4() ? kIpv4Offset : 0;
  const std::size_t end = holdsIpv4() ? bytes.size() : kHouseholdBytes;
  for (std::size_t i = first; i < end; ++i) number = number << 8 | bytes[i];
  return number == kLoopbackNetwork ? kZeroNetwork : number;
}

std::uint64_t IpAddress::site() const {
  if (isLoopback() || holdsIpv4()) return household();
  const std::uint64_t number = household() & ~std::uint64_t{0xffff};
  return number == kLoopbackNetwork ? kZeroNetwork : number;
}

std::string IpAddress::text() const {
  std::array<char, INET6_ADDRSTRLEN> buffer{};
  const bool ipv4 = isIpv4();
  inet_ntop(ipv4 ? AF_INET : AF_INET6, bytes.data() + (ipv4 ? kIpv4Offset : 0), buffer.data(), buffer.size());
  return buffer.data();
}

std::string SocketAddress::text() const {
  return (ip.isIpv4() ? ip.text() : "[" + ip.text() + "]") + ":" + std::to_string(port);
}

SocketAddress fromSystem(const SystemAddress& system) {
  SocketAddress address;
  if (system.any.sa_family == AF_INET6) {
    std::memcpy(address.ip.bytes.data(), &system.ipv6.sin6_addr, address.ip.bytes.size());
    address.port = ntohs(system.ipv6.sin6_port);
    return address;
  }
  std::array<std::uint8_t, sizeof(in_addr)> bytes{};
  std::memcpy(bytes.data(), &system.ipv4.sin_addr, bytes.size());
  return {IpAddress::ofIpv4(bytes), ntohs(system.ipv4.sin_port)};
}

socklen_t toSystem(const SocketAddress& address, bool ipv6, SystemAddress& system) {
  std::memset(&system, 0, sizeof system);
  if (ipv6) {
    system.ipv6.sin6_family = AF_INET6;
    system.ipv6.sin6_port = htons(address.port);
    std::memcpy(&system.ipv6.sin6_addr, address.ip.bytes.data(), address.ip.bytes.size());
    return sizeof system.ipv6;
  }
  system.ipv4.sin_family = AF_INET;
  system.ipv4.sin_port = htons(address.port);
  const auto bytes = address.ip.ipv4();
  std::memcpy(&system.ipv4.sin_addr, bytes.data(), bytes.size());
  return sizeof system.ipv4;
}

}  // namespace platon
