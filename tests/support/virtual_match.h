#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/net/network_conditions.h"
#include "client/session/session.h"
#include "client/time/moment.h"
#include "server/match/match.h"

namespace platon {

/// A match and its clients in one thread and in virtual time: client sessions and the server's Match, connected by
/// simulated connections. Unreliable messages are subject to all simulated conditions, reliable ones only to the delay,
/// as if the transport below retransmitted them.
class VirtualMatch {
 public:
  VirtualMatch(std::vector<std::shared_ptr<const Level>> levels, std::uint64_t seed, std::uint32_t maxPlayers = 16);

  /// A client with these controls joins now. Returns its index.
  std::size_t join(const LinkQuality& quality, Controls controls);
  /// The client's connection is lost, with all messages in flight. The server detects it after `detectedAfter`;
  /// nothing: never.
  void disconnect(std::size_t client, std::optional<Moment> detectedAfter);
  /// The client reconnects under the same conditions and continues with the memory of its last session.
  void resume(std::size_t client);
  /// Time between two updates of the clients; default 4 ms.
  void setFrame(Moment frame) { frame_ = frame; }
  /// From now on, `change` may modify every message to this client.
  void tamper(std::size_t client, std::function<void(std::vector<std::uint8_t>&)> change);
  /// Whether `run` checks this client. Default: true.
  void setChecked(std::size_t client, bool checked) { clients_[client]->checked = checked; }
  /// Lets time pass. Checks after each update of a client that its confirmed game equals the server's.
  void run(Moment duration);

  Moment now() const { return now_; }
  Match& match() { return match_; }
  const Session& session(std::size_t client) const { return *clients_[client]->session; }
  Session& session(std::size_t client) { return *clients_[client]->session; }
  std::optional<DesyncReport> takeDesync(std::size_t client) { return clients_[client]->session->takeDesync(); }
  std::uint32_t slot(std::size_t client) const { return clients_[client]->session->welcome()->slot; }
  /// Hash of the server's game.
  std::uint64_t hashOf(std::uint32_t round, std::uint32_t tick) const { return hashes_.at({round, tick}); }

 private:
  struct Client {
    Client(ClientId number, const LinkQuality& quality, std::uint64_t seed, Controls buttons);

    ClientId id;  // of the current connection
    bool connected = true;
    std::optional<Session> session;
    Controls controls;
    NetworkConditions up, down, reliableUp, reliableDown;
    std::function<void(std::vector<std::uint8_t>&)> tamper = [](std::vector<std::uint8_t>&) {};
    bool checked = true;
  };

  Client* connectedAs(ClientId id);
  void detectDisconnects();
  void tickServer();
  void transfer(Client& client);
  void check(const Session& session) const;

  Match match_;
  std::uint64_t seed_;
  Moment now_ = std::chrono::seconds(100);
  Moment frame_ = std::chrono::milliseconds(4);
  Moment nextFrame_ = now_;
  std::uint64_t serverTicks_ = 0;
  std::vector<std::unique_ptr<Client>> clients_;
  ClientId nextId_ = 1;
  std::vector<std::pair<Moment, ClientId>> losses_;  // when the server detects which lost connection
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> hashes_;  // of the server's game, by round and tick
  std::uint32_t round_ = 0;
  std::uint32_t ticksInRound_ = 0;
};

}  // namespace platon
