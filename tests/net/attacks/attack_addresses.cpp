#include "tests/net/attacks/attack_addresses.h"

namespace platon {
namespace {

constexpr int kStrangersPerNetwork = 250;

enum Kind { kStranger = 1, kPlayer = 2, kOwn = 3 };

std::uint8_t lowByte(int number) { return static_cast<std::uint8_t>(number); }

// 127.KIND.NETWORK.HOST
IpAddress ipv4(Kind kind, int network, int host) {
  IpAddress address;
  address.bytes = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 127, lowByte(kind), lowByte(network), lowByte(host)};
  return address;
}

// fd00:0:KIND:NETWORK::HOST
IpAddress ipv6(Kind kind, int network, int host) {
  IpAddress address;
  address.bytes[0] = 0xfd;
  address.bytes[5] = lowByte(kind);
  address.bytes[7] = lowByte(network);
  address.bytes[14] = lowByte(host >> 8);
  address.bytes[15] = lowByte(host);
  return address;
}

}  // namespace

IpAddress serverAddress(IpVersion version) {
  return IpAddress::parse(version == IpVersion::kIpv4 ? "127.0.0.1" : "::1").value();
}

IpAddress playerAddress(IpVersion version, int number) {
  return version == IpVersion::kIpv4 ? ipv4(kPlayer, 0, number) : ipv6(kPlayer, number, 1);
}

IpAddress ownAddress(IpVersion version, int number) {
  const int household = number % kOwnHouseholds;
  if (version == IpVersion::kIpv4) return ipv4(kOwn, 0, 1 + household);
  return ipv6(kOwn, household, 1 + number / kOwnHouseholds);
}

SocketAddress strangerAddress(IpVersion version, int number) {
  const int network = number / kStrangersPerNetwork;
  const int host = 1 + number % kStrangersPerNetwork;
  return {version == IpVersion::kIpv4 ? ipv4(kStranger, network, host) : ipv6(kStranger, network, host), 4000};
}

}  // namespace platon
