#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace platon {

/// An IP address. IPv4 addresses are stored in their IPv6 form ::ffff:a.b.c.d, so that one address has one value.
struct IpAddress {
  std::array<std::uint8_t, 16> bytes{};

  /// Parses an IPv4 or IPv6 address without brackets and without a zone. Nothing if it is neither.
  static std::optional<IpAddress> parse(std::string_view text);

  static IpAddress ofIpv4(const std::array<std::uint8_t, 4>& bytes);

  bool isIpv4() const;
  /// Whether it stands for an IPv4 address: it is one, or holds one in its last four bytes as an address of
  /// 64:ff9b::/96, to which a translator between IPv4 and IPv6 maps those of IPv4 (RFC 6052).
  bool holdsIpv4() const;
  /// The four bytes of an IPv4 address.
  std::array<std::uint8_t, 4> ipv4() const;
  /// Exactly 127.0.0.1 or ::1. Other addresses of 127.0.0.0/8 do not count.
  bool isLoopback() const;
  /// 127.0.0.0/8 or ::1: only this machine can have the address. It may have others that are not recognised.
  bool isThisMachine() const;
  /// Whether the internet does not lead to the address: it is one of this machine, of its link, of a private network,
  /// or of a provider's translator, or 0.0.0.0/8 or ::, which lead to this machine.
  bool isPrivate() const;
  /// Number of the part that one household or host controls: all of an IPv4 address, also of one that an IPv6 address
  /// holds; the first 64 bits of another IPv6 address. 0 for loopback.
  std::uint64_t household() const;
  /// The network of one owner: the first 48 bits of an IPv6 address, with 256 to 65 536 households; an IPv4 address,
  /// also one that an IPv6 address holds, is one by itself. 0 for loopback.
  std::uint64_t site() const;
  /// "192.0.2.1" or "2001:db8::1"
  std::string text() const;

  // clang-tidy 14 takes the comparison for a null pointer.
  friend auto operator<=>(const IpAddress&, const IpAddress&) = default;  // NOLINT(modernize-use-nullptr)
};

/// An IP address and a UDP port.
struct SocketAddress {
  IpAddress ip;
  std::uint16_t port = 0;

  /// "192.0.2.1:7777" or "[2001:db8::1]:7777"
  std::string text() const;

  friend auto operator<=>(const SocketAddress&, const SocketAddress&) = default;  // NOLINT(modernize-use-nullptr)
};

/// An address as the functions of the system take it; `any.sa_family` tells the kind.
union SystemAddress {
  sockaddr any;
  sockaddr_in ipv4;
  sockaddr_in6 ipv6;
};

/// The address of an AF_INET or AF_INET6 one.
SocketAddress fromSystem(const SystemAddress& system);

/// Fills `system` for a socket of the family AF_INET6 (`ipv6`) or AF_INET, and returns its size. An IPv6 socket also
/// takes IPv4 addresses, an IPv4 socket only these.
socklen_t toSystem(const SocketAddress& address, bool ipv6, SystemAddress& system);

}  // namespace platon
