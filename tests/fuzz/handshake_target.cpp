#include "protocol/limits.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/handshake_forms.h"
#include "tests/fuzz/handshake_world.h"

namespace platon::fuzz {
namespace {

using std::chrono::milliseconds;

constexpr int kMaxHandshakeSteps = 150;
constexpr auto kVersion = static_cast<std::uint16_t>(kProtocolVersion);

/// The attacker, who is in charge of everything that happens.
class Attacker {
 public:
  explicit Attacker(ByteSource& bytes) : bytes_(bytes), world_(setup()) {}

  std::string run() {
    for (int i = 0; i < kMaxHandshakeSteps && !bytes_.empty() && world_.fault().empty(); ++i) step();
    world_.checkNewcomer();
    return world_.fault();
  }

 private:
  HandshakeWorld::Setup setup() {
    HandshakeWorld::Setup setup;
    setup.sessions = static_cast<std::uint32_t>(bytes_.between(1, HandshakeWorld::kMaxSessions));
    setup.sessionsPerHousehold = static_cast<std::uint32_t>(bytes_.between(1, 2));
    setup.clientsKnowIdentity = bytes_.flag();
    setup.needsPassword = bytes_.below(4) == 3;
    setup.clientsHavePassword = !setup.needsPassword && bytes_.below(4) == 3;
    return setup;
  }

  void step() {
    switch (bytes_.below(10)) {
      case 0:
        return world_.updateClient(anyClient());
      case 1:
      case 2:
        return passOn();
      case 7:
        return shakeHands(anyClient());
      case 8:
        return move();
      case 3:
        return passOnChanged();
      case 4:
        return inventToServer();
      case 5:
        return inventToClient();
      case 6:
        return join();
      default:
        return act();
    }
  }

  // What happens without a datagram of the attacker.
  void act() {
    constexpr Time kWaits[] = {milliseconds(1), milliseconds(100), milliseconds(500), std::chrono::seconds(3),
                               std::chrono::seconds(60)};
    switch (bytes_.below(8)) {
      case 0:
        return world_.restartClient(anyClient());
      case 1:
        return sendFromClient(anyClient());
      case 2:
        return sendFromServer();
      case 3:
        return world_.confirm(bytes_.byte());
      case 4:
        return world_.close(bytes_.byte());
      case 5:
        return world_.expire();
      case 6:
        return world_.setBanned(bytes_.flag());
      default:
        return world_.wait(kWaits[bytes_.below(std::size(kWaits))]);
    }
  }

  // The choices of a call are made one after the other, in an order that does not depend on the compiler.
  void inventToServer() {
    const SocketAddress& from = anyAddress();
    world_.deliverToServer(from, made());
  }
  void inventToClient() {
    const std::size_t client = anyClient();
    const SocketAddress& from = bytes_.flag() ? anyAddress() : HandshakeWorld::server();
    world_.deliverToClient(client, from, made());
  }
  void sendFromClient(std::size_t client) { world_.sendFromClient(client, anySize()); }
  void sendFromServer() {
    const std::uint8_t session = bytes_.byte();
    world_.sendFromServer(session, anySize());
  }

  std::size_t anySize() {
    return static_cast<std::size_t>(bytes_.between(HandshakeWorld::kMinContentBytes, HandshakeWorld::kMaxContentBytes));
  }
  std::size_t anyClient() { return bytes_.below(HandshakeWorld::kClients); }
  const SocketAddress& anyAddress() {
    return HandshakeWorld::addresses()[bytes_.below(HandshakeWorld::addresses().size())];
  }

  // One of the last datagrams; null if there is none.
  const DatagramNetwork::Sent* anySent() {
    const auto& sent = world_.sent();
    return sent.empty() ? nullptr : &sent[sent.size() - 1 - bytes_.below(std::min<std::size_t>(sent.size(), 64))];
  }

  void deliver(const SocketAddress& from, const SocketAddress& to, ByteSpan datagram) {
    if (to == HandshakeWorld::server()) return world_.deliverToServer(from, datagram);
    for (std::size_t i = 0; i < HandshakeWorld::kClients; ++i) {
      if (HandshakeWorld::addresses()[i] == to) return world_.deliverToClient(i, from, datagram);
    }
    world_.deliverToClient(anyClient(), from, datagram);  // a client that has moved there
  }

  void passOn() {
    const DatagramNetwork::Sent* const found = anySent();
    if (found == nullptr) return;
    const DatagramNetwork::Sent sent = *found;
    deliver(bytes_.below(4) == 3 ? anyAddress() : sent.from, sent.to, sent.bytes);
  }

  void passOnChanged() {
    const DatagramNetwork::Sent* const found = anySent();
    if (found == nullptr) return;
    DatagramNetwork::Sent sent = *found;
    change(sent.bytes);
    deliver(sent.from, sent.to, sent.bytes);
  }

  void change(platon::Bytes& datagram) {
    const std::size_t kind = bytes_.below(8);
    if (kind == 0) datagram.resize(bytes_.below(datagram.size() + 1));
    if (kind == 1) datagram.resize(datagram.size() + bytes_.below(256));
    if (kind == 2) datagram.push_back(bytes_.byte());
    for (std::size_t i = 2; i < kind && !datagram.empty(); ++i)
      datagram[bytes_.below(datagram.size())] ^= bytes_.byte();
  }

  // A whole handshake without a client of ours, from any address.
  void join() {
    const SocketAddress& from = anyAddress();
    const bool isRight = bytes_.flag();
    world_.deliverToServer(from, world_.knock());
    const platon::Bytes open = world_.openFor(from, isRight);
    world_.deliverToServer(bytes_.below(4) == 3 ? anyAddress() : from, open);
  }

  // Delivers all that was sent after the first `begin`, unchanged, until nobody answers.
  void passOnAll(std::size_t begin, std::size_t client, const SocketAddress& own) {
    for (std::size_t i = begin; i < world_.sent().size(); ++i) {
      const DatagramNetwork::Sent sent = world_.sent()[i];
      if (sent.to == HandshakeWorld::server()) {
        world_.deliverToServer(own, sent.bytes);
      } else {
        world_.deliverToClient(client, sent.from, sent.bytes);
      }
    }
  }

  void shakeHands(std::size_t client) {
    const std::size_t begin = world_.sent().size();
    world_.wait(ClientGate::kRepeatInterval);
    world_.updateClient(client);
    passOnAll(begin, client, HandshakeWorld::addresses()[client]);
  }

  // A client sends from another address and receives there.
  void move() {
    const std::size_t client = anyClient();
    const SocketAddress& address = anyAddress();
    const std::size_t begin = world_.sent().size();
    sendFromClient(client);
    passOnAll(begin, client, address);
  }

  template <std::size_t kSize>
  void fill(std::array<std::uint8_t, kSize>& field) {
    for (std::uint8_t& byte : field) byte = bytes_.byte();
  }

  // A datagram from nothing: of one of the known kinds, or any bytes.
  platon::Bytes made() {
    platon::Bytes datagram = plain();
    if (bytes_.below(4) == 3 && !datagram.empty()) change(datagram);
    return datagram;
  }

  platon::Bytes plain() {
    switch (bytes_.below(8)) {
      case 0:
        return encode(Knock{bytes_.flag() ? kVersion : std::uint16_t{bytes_.byte()}, key()});
      case 1:
        return encode(CookieReply{echoOf(key()), bytes_.flag(), identity(), cookie()});
      case 2:
        return encode(open());
      case 3:
        return encode(accept());
      case 4:
        return encode(Refusal{kVersion, echoOf(key()), static_cast<RefusalReason>(bytes_.below(8)), "a reason"});
      case 5:
        return encode(Query{bytes_.byte()});
      case 6:
        return encode(Info{kVersion, bytes_.byte(), key(), bytes_.flag(), 1, 2, "name", "1.0"});
      default:
        return anyBytes();
    }
  }

  // A key that somebody uses, or a new one.
  CryptoKey key() {
    const DatagramNetwork::Sent* const sent = bytes_.flag() ? anySent() : nullptr;
    const auto knock = sent == nullptr ? std::nullopt : decodeKnock(sent->bytes);
    CryptoKey key{bytes_.byte()};
    return knock ? knock->clientKey : key;
  }

  // Of the server, or of somebody in its place.
  CryptoKey identity() {
    static const CryptoKey other = ServerIdentity(CryptoKey{8}).publicKey();
    return bytes_.flag() ? other : HandshakeWorld::identity();
  }

  Cookie cookie() {
    Cookie cookie;
    fill(cookie);
    return cookie;
  }

  Open open() {
    Open open{cookie(), {}};
    const CryptoKey client = key();
    std::copy(client.begin(), client.end(), open.exchange.begin());
    return open;
  }

  Accept accept() {
    Accept accept{echoOf(key()), {}};
    fill(accept.exchange);
    return accept;
  }

  platon::Bytes anyBytes() {
    platon::Bytes bytes(bytes_.below(40));
    for (std::uint8_t& byte : bytes) byte = bytes_.byte();
    return bytes;
  }

  ByteSource& bytes_;
  HandshakeWorld world_;
};

}  // namespace

std::string handshakeFault(Bytes input) {
  ByteSource bytes(input);
  if (bytes.below(8) == 7) return handshakeFormFault(bytes.remaining());
  return Attacker(bytes).run();
}

}  // namespace platon::fuzz
