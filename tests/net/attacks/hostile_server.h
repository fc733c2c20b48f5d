#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "client/net/enet_link.h"
#include "client/session/session.h"
#include "server/net/host.h"
#include "tests/net/attacks/buffered_socket.h"
#include "tests/net/support/datagram_network.h"
#include "tests/net/support/pressing.h"

namespace platon {

/// A server that sends what it likes to a client of ours, in virtual time.
class HostileServer {
 public:
  /// Called every millisecond once the client has said Hello.
  using Attack = std::function<void(HostileServer&)>;

  HostileServer();
  /// Lets this time pass, by default six seconds, or less if the client's session ends.
  void run(std::chrono::milliseconds time, const Attack& attack);
  void run(const Attack& attack) { run(std::chrono::seconds(6), attack); }

  /// Sends a message; a reliable one only while the client keeps up. Returns whether it was sent.
  bool send(bool reliable, ByteSpan message);
  /// The same for any message that can be encoded.
  template <class Message>
  bool send(const Message& message) {
    return send(!std::is_same_v<Message, ConfirmedTicks>, encode(message));
  }
  /// Sends Welcome and a level without a reachable goal, so that a round begins.
  void welcome();
  /// Seals a content in ENet's format.
  void sendContent(ByteSpan content) { host_.gate().send({1, 0}, content, now_); }
  /// Sends a datagram as it is.
  void sendDatagram(ByteSpan datagram);
  /// Number of this call of the attack, from 0.
  std::uint32_t call() const { return calls_; }

  const Session& session() const { return *session_; }
  bool isConnected() const { return client_.state() == EnetLink::State::kConnected; }
  /// Most memory that the client had more than before the attack, bytes.
  std::int64_t heapGrowth() const { return highest_; }

 private:
  void step(const Attack& attack);
  void serve();
  void stepClient();
  void updateClient();

  DatagramNetwork network_;
  Time now_ = std::chrono::seconds(1000);
  Host host_;
  BufferedSocket* clientSocket_;  // client_ owns it
  EnetLink client_;
  Controls controls_ = pressing(1);
  std::optional<Session> session_;  // once connected
  std::optional<ClientId> joined_;
  std::uint32_t calls_ = 0;
  std::int64_t heap_ = 0;
  std::int64_t highest_ = 0;
};

}  // namespace platon
