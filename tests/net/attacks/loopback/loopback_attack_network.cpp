#include "tests/net/attacks/loopback/loopback_attack_network.h"

#include "protocol/transport/udp_socket.h"

namespace platon {
namespace {

IpAddress anyAddress(IpVersion version) {
  return IpAddress::parse(version == IpVersion::kIpv4 ? "0.0.0.0" : "::").value();
}

}  // namespace

/// A socket of the attacker, whose datagrams are counted.
class LoopbackAttackNetwork::CountingSocket : public DatagramSocket {
 public:
  CountingSocket(LoopbackAttackNetwork& network, const IpAddress& own) : network_(network), socket_(own.text(), 0) {}

  std::optional<Datagram> receive(Time now) override {
    const std::optional<Datagram> datagram = socket_.receive(now);
    if (datagram) network_.noteReceived(datagram->bytes.size());
    return datagram;
  }
  void send(const SocketAddress& receiver, ByteSpan bytes, Time now) override {
    network_.count(bytes);
    socket_.send(receiver, bytes, now);
  }
  void flush(Time now) override { socket_.flush(now); }
  void wait(std::chrono::milliseconds timeout) override { socket_.wait(timeout); }
  SocketAddress address() const override { return socket_.address(); }

 private:
  LoopbackAttackNetwork& network_;
  UdpSocket socket_;
};

LoopbackAttackNetwork::LoopbackAttackNetwork(const SocketAddress& server)
    : server_(server), relay_(server.ip), strangers_(anyAddress(version())) {}

void LoopbackAttackNetwork::count(ByteSpan datagram) {
  ++sent_;
  noteSent(datagram.size());
}

void LoopbackAttackNetwork::send(const SocketAddress& from, ByteSpan datagram) {
  count(datagram);
  const auto victim = victims_.find(from);
  if (victim != victims_.end()) return victim->second->socket->send(server_, datagram);
  strangers_.sendFrom(from.ip, server_, datagram);
}

std::unique_ptr<DatagramSocket> LoopbackAttackNetwork::socket(const IpAddress& own) {
  return std::make_unique<CountingSocket>(*this, own);
}

LoopbackAttackNetwork::Player& LoopbackAttackNetwork::playerAt(const SocketAddress& own) {
  std::unique_ptr<Player>& player = players_[own];
  if (!player) {
    const IpAddress address = playerAddress(version(), static_cast<int>(players_.size()));
    player = std::make_unique<Player>(Player{own, std::make_unique<LoopbackSocket>(address)});
    victims_[player->socket->address()] = player.get();
  }
  return *player;
}

void LoopbackAttackNetwork::pump() {
  while (const auto datagram = relay_.receive()) {
    Player& player = playerAt(datagram->peer);
    note(player.socket->address(), true, datagram->bytes);
    player.socket->send(server_, datagram->bytes);
  }
  for (auto& [address, player] : victims_) {
    while (const auto datagram = player->socket->receive()) {
      note(address, false, datagram->bytes);
      relay_.send(player->own, datagram->bytes);
    }
  }
  while (const auto datagram = strangers_.receive()) {
    answeredBytes_ += datagram->bytes.size();
    noteReceived(datagram->bytes.size());
  }
}

}  // namespace platon
