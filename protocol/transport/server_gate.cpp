#include "protocol/transport/server_gate.h"

namespace platon {
namespace {

// False for an address that the system cannot send to, or that reaches more than one receiver.
bool canAnswer(const SocketAddress& address) {
  if (address.port == 0) return false;
  if (!address.ip.isIpv4()) return address.ip.bytes[0] != 0xff && address.ip != IpAddress{};
  const std::uint8_t network = address.ip.ipv4()[0];
  return network != 0 && network < 224;
}

}  // namespace

ServerGate::ServerGate(std::unique_ptr<DatagramSocket> socket, const ServerIdentity& identity,
                       const GateSettings& settings, Time now, GateRules rules)
    : socket_(std::move(socket)),
      rules_(std::move(rules)),
      sessions_(settings, rules_, socket_, rejections_),
      admission_(identity, settings, rules_, socket_, sessions_, rejections_, now) {}

std::optional<ServerGate::Received> ServerGate::receive(Time now) {
  for (; left_ > 0; --left_) {
    const std::optional<Datagram> datagram = socket_.receive(now);
    if (!datagram) return std::nullopt;
    if (std::optional<Received> received = take(*datagram, now)) return received;
  }
  return std::nullopt;
}

std::optional<ServerGate::Received> ServerGate::take(const Datagram& datagram, Time now) {
  const std::size_t size = datagram.bytes.size();
  if (!canAnswer(datagram.peer) || size == 0 || size > kMaxDatagramBytes) {
    ++rejections_.malformed;
    return std::nullopt;
  }
  if (SealedChannel::isSealed(datagram.bytes)) return sessions_.receive(datagram, now);
  admission_.receive(datagram, now);
  return std::nullopt;
}

}  // namespace platon
