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

/// A match and its clients in one thread and in a time of its own: sessions on one side, the server's Match on the
/// other, simulated lines in between. Unreliable messages are subject to the line; reliable ones to its delay alone,
/// as the transport below them would see to it.
class VirtualMatch {
 public:
  VirtualMatch(std::vector<std::shared_ptr<const Level>> levels, std::uint64_t seed, std::uint32_t maxPlayers = 16);

  /// A client with these controls joins now; its index.
  std::size_t join(const LinkQuality& line, Controls controls);
  /// The client's connection is lost, with all that is on its way. The server notices after so long, or never.
  void breakOff(std::size_t client, std::optional<Moment> noticedAfter);
  /// The client has a new connection over the same line, and what it remembers.
  void comeBack(std::size_t client);
  /// How often clients update from now on; 4 ms at first.
  void setFrame(Moment frame) { frame_ = frame; }
  /// Every message to this client is handed to `change` on its way, from now on.
  void tamper(std::size_t client, std::function<void(std::vector<std::uint8_t>&)> change);
  /// Whether `run` checks this client; all are checked at first.
  void setChecked(std::size_t client, bool checked) { clients_[client]->checked = checked; }
  /// Lets time pass. Checks all the while, for every client, that its confirmed game is the server's.
  void run(Moment duration);

  Moment now() const { return now_; }
  Match& match() { return match_; }
  const Session& session(std::size_t client) const { return *clients_[client]->session; }
  Session& session(std::size_t client) { return *clients_[client]->session; }
  std::optional<DesyncReport> takeDesync(std::size_t client) { return clients_[client]->session->takeDesync(); }
  std::uint32_t slot(std::size_t client) const { return clients_[client]->session->welcome()->slot; }
  /// The server's game by round and tick.
  std::uint64_t hashOf(std::uint32_t round, std::uint32_t tick) const { return hashes_.at({round, tick}); }

 private:
  struct Client {
    Client(ClientId number, const LinkQuality& line, std::uint64_t seed, Controls buttons);

    ClientId id;  // of its connection
    bool connected = true;
    std::optional<Session> session;
    Controls controls;
    NetworkConditions up, down, reliableUp, reliableDown;
    std::function<void(std::vector<std::uint8_t>&)> tamper = [](std::vector<std::uint8_t>&) {};
    bool checked = true;
  };

  Client* connectedAs(ClientId id);
  void tellOfLosses();
  void tickServer();
  void carry(Client& client);
  void check(const Session& session) const;

  Match match_;
  std::uint64_t seed_;
  Moment now_ = std::chrono::seconds(100);
  Moment frame_ = std::chrono::milliseconds(4);
  Moment nextFrame_ = now_;
  std::uint64_t serverTicks_ = 0;
  std::vector<std::unique_ptr<Client>> clients_;
  ClientId nextId_ = 1;
  std::vector<std::pair<Moment, ClientId>> losses_;                          // that the server will notice
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> hashes_;  // of the server's game by round and tick
  std::uint32_t round_ = 0;
  std::uint32_t ticksInRound_ = 0;
};

}  // namespace platon
