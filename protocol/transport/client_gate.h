#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/handshake.h"
#include "protocol/transport/sealed_channel.h"
#include "protocol/transport/server_identity.h"

namespace platon {

/// What a client knows about a server before it connects.
struct ServerKnowledge {
  std::optional<CryptoKey> identity;  ///< the only identity to accept; nothing: any
  Password password{};                ///< none, or the server must ask for one
};

/// The client's end of a session: shakes hands with a server, then seals what it sends and opens what it receives.
class ClientGate {
 public:
  /// Pause between two repetitions of an unanswered handshake datagram.
  static constexpr Time kRepeatInterval = std::chrono::milliseconds(250);

  enum class State {
    kHandshake,
    kOpen,
    kRefused,          ///< `refusal` tells why
    kNoPasswordAsked,  ///< there is a password, but the server does not ask for one
    kNoPassword,       ///< the server asks for a password, and there is none
    kAnotherIdentity,  ///< the server is not the one that was expected
  };

  /// `servers`: addresses of the same server; the first that answers is used. `ephemeral`: new for each gate.
  ClientGate(std::unique_ptr<DatagramSocket> socket, std::vector<SocketAddress> servers, ServerKnowledge knowledge,
             const KeyPair& ephemeral);

  /// Sends what the handshake needs. Call it regularly.
  void update(Time now);
  /// Datagrams that one round of `receive` takes, so that a flood does not keep the client from its work.
  static constexpr std::size_t kMaxDatagramsPerRound = 1024;
  /// Begins a round of `receive`.
  void beginRound() { left_ = kMaxDatagramsPerRound; }
  /// The next content from the server; nothing when no datagram waits, or the round has taken all that it may.
  std::optional<Bytes> receive(Time now);
  /// Seals and queues; no effect unless open.
  void send(ByteSpan content, Time now);
  /// The same for the transport itself.
  void sendControl(ByteSpan content, Time now);
  void flush(Time now) { socket_.flush(now); }

  State state() const { return state_; }
  const std::optional<Refusal>& refusal() const { return refusal_; }
  /// Public key of the server; proved once the gate is open.
  const std::optional<CryptoKey>& identity() const { return identity_; }
  /// The server's address; the first one until one has answered.
  const SocketAddress& server() const { return servers_.front(); }
  DatagramSocket& socket() const { return socket_.socket(); }
  const Traffic& traffic() const { return socket_.traffic(); }

 private:
  std::optional<Bytes> take(const Datagram& datagram, Time now);
  void takeHandshake(const Datagram& datagram, Time now);
  void takeCookie(const SocketAddress& server, const CookieReply& reply, Time now);
  void takeAccept(const Accept& accept);
  void takeRefusal(const Refusal& refusal);
  std::optional<Bytes> takeSealed(ByteSpan datagram, Time now);
  bool isServer(const SocketAddress& address) const;

  CountedSocket socket_;
  std::vector<SocketAddress> servers_;
  ServerKnowledge knowledge_;
  KeyPair ephemeral_;
  State state_ = State::kHandshake;
  Bytes request_;  // repeated until it is answered
  std::optional<Time> sentAt_;
  std::optional<NoiseExchange> exchange_;  // once the cookie has come
  std::optional<CryptoKey> identity_;
  std::optional<Refusal> refusal_;
  std::optional<SealedChannel> channel_;
  std::size_t left_ = kMaxDatagramsPerRound;  // datagrams of this round
};

}  // namespace platon
