#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/server_admission.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/server_sessions.h"

namespace platon {

/// The server's wall: only datagrams of a session pass. What is sealed goes to the sessions, everything else to the
/// admission, which answers handshakes and begins sessions. docs/protocol.md specifies both.
class ServerGate {
 public:
  ServerGate(std::unique_ptr<DatagramSocket> socket, const ServerIdentity& identity, const GateSettings& settings,
             Time now, GateRules rules = {});
  ServerGate(const ServerGate&) = delete;
  ServerGate& operator=(const ServerGate&) = delete;

  using Received = ServerSessions::Received;
  /// Datagrams that one round of `receive` takes, so that a flood does not keep the server from its work.
  static constexpr std::size_t kMaxDatagramsPerRound = 2048;

  /// Begins a round of `receive`.
  void beginRound() { left_ = kMaxDatagramsPerRound; }
  /// The next content from a session. Answers all other datagrams on the way; nothing when no datagram waits, or the
  /// round has taken all that it may.
  std::optional<Received> receive(Time now);
  /// Seals and queues content for a session (ServerSessions::send).
  void send(SessionId session, ByteSpan content, Time now) { sessions_.send(session, content, now); }
  void flush(Time now) { socket_.flush(now); }

  /// Call when the session serves a connection: from then on only `close` ends it.
  void confirm(SessionId session) { sessions_.confirm(session); }
  /// Ends sessions that were not confirmed in time. Call it regularly.
  void expire(Time now) { sessions_.expire(now); }
  /// Ends a session. Its datagrams are dropped from now on.
  void close(SessionId session) { sessions_.close(session); }
  bool isOpen(SessionId session) const { return sessions_.isOpen(session); }
  /// Address of an open session.
  IpAddress addressOf(SessionId session) const { return sessions_.addressOf(session); }

  /// What queries are told. `version`, `nonce`, `identity` and `needsPassword` are filled in.
  void setInfo(Info info) { admission_.setInfo(std::move(info)); }

  DatagramSocket& socket() const { return socket_.socket(); }
  const Traffic& traffic() const { return socket_.traffic(); }
  /// All that the gate has rejected, and what those behind it add.
  Rejections& rejections() { return rejections_; }
  const Rejections& rejections() const { return rejections_; }

 private:
  std::optional<Received> take(const Datagram& datagram, Time now);

  CountedSocket socket_;
  GateRules rules_;
  Rejections rejections_;
  ServerSessions sessions_;
  ServerAdmission admission_;
  std::size_t left_ = kMaxDatagramsPerRound;  // datagrams of this round
};

}  // namespace platon
