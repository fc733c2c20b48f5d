#include "tests/net/attacks/hostile_session.h"

#include <enet/enet.h>

#include "tests/net/support/raw_content.h"

namespace platon {
namespace {

constexpr std::uint8_t kNoChannel = 0xff;

}  // namespace

/// A socket that can send in other names.
class HostileSession::MaskedSocket : public DatagramSocket {
 public:
  MaskedSocket(AttackNetwork& network, const IpAddress& own) : network_(network), own_(network.socket(own)) {}

  std::optional<Datagram> receive(Time now) override { return own_->receive(now); }
  void send(const SocketAddress& receiver, ByteSpan bytes, Time now) override {
    if (mask_) return network_.send(*mask_, bytes);
    if (!left_) own_->send(receiver, bytes, now);
  }
  void flush(Time now) override { own_->flush(now); }
  void wait(std::chrono::milliseconds timeout) override { own_->wait(timeout); }
  SocketAddress address() const override { return own_->address(); }
  void setMask(const std::optional<SocketAddress>& mask) { mask_ = mask; }
  void leave() { left_ = true; }
  void move(const IpAddress& own) { own_ = network_.socket(own); }

 private:
  AttackNetwork& network_;
  std::unique_ptr<DatagramSocket> own_;
  std::optional<SocketAddress> mask_;
  bool left_ = false;
};

HostileSession::HostileSession(AttackNetwork& network, const IpAddress& own, Receiver receiver)
    : HostileSession(network, std::make_unique<MaskedSocket>(network, own), std::move(receiver)) {}

HostileSession::HostileSession(AttackNetwork& network, std::unique_ptr<MaskedSocket> socket, Receiver receiver)
    : socket_(socket.get()),
      gate_(std::move(socket), {network.server()}, {}, KeyPair::random()),
      receiver_(std::move(receiver)) {}

HostileSession::~HostileSession() = default;

void HostileSession::step(Time now) {
  gate_.update(now);
  while (const std::optional<Bytes> content = gate_.receive(now)) {
    note(*content, now);
    if (receiver_) receiver_(*content);
  }
  if (isSealed() && !requested_) {
    requested_ = true;
    send(connectContent(77), now);
  }
  gate_.flush(now);
}

// The server's number of the connection follows the command header of VERIFY_CONNECT; ENet's session number follows in
// the head of what is sent to it.
void HostileSession::note(const Bytes& content, Time now) {
  const std::size_t at = kCommandAt;
  if (peer_ || content.size() < at + 8) return;
  if ((content[at] & ENET_PROTOCOL_COMMAND_MASK) != ENET_PROTOCOL_COMMAND_VERIFY_CONNECT) return;
  const int number = content[at + 4] << 8 | content[at + 5];
  peer_ = static_cast<std::uint16_t>(number | content[at + 7] << ENET_PROTOCOL_HEADER_SESSION_SHIFT);
  send(acknowledgeContent(*peer_, 1, kNoChannel, sentTimeOf(content)), now);
}

void HostileSession::sendFrom(const SocketAddress& name, ByteSpan content, Time now) {
  socket_->setMask(name);
  send(content, now);
  socket_->setMask(std::nullopt);
}

void HostileSession::leaveAddress() { socket_->leave(); }

void HostileSession::move(const IpAddress& own) { socket_->move(own); }

}  // namespace platon
