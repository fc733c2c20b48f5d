#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/time/clock.h"
#include "protocol/to_client.h"
#include "protocol/transport/noise.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// What a server in this program plays, and for whom.
struct EmbeddedSettings {
  std::vector<std::string> levels{};  ///< files, in the order in which they are played; empty: the shipped levels
  bool listens = false;               ///< to the network; otherwise only to this machine, on a free port
  std::uint16_t port = kDefaultPort;  ///< of the network
  std::string password{};             ///< empty: none
  std::uint32_t maxPlayers = 16;      ///< 1 … kMaxPlayers
  bool waitsForOne = false;           ///< as MatchSettings::waitsForOne
  bool stepped = false;               ///< it has no thread, and runs in EmbeddedServer::step
};

/// A dedicated server in this program, in a thread of its own unless it is stepped.
class EmbeddedServer {
 public:
  /// Starts the server. Throws ProgramError. When the file of its only level changes, a new round plays it. If it is
  /// invalid, the old level stays, and a notice and stderr say why. The server goes by `clock`; without it, by the
  /// clock of the system. A server that listens to the network has the identity of the user's other servers.
  explicit EmbeddedServer(const EmbeddedSettings& settings,
                          const std::shared_ptr<const PausableClock>& clock = nullptr);
  /// Stops the server.
  ~EmbeddedServer();
  EmbeddedServer(const EmbeddedServer&) = delete;
  EmbeddedServer& operator=(const EmbeddedServer&) = delete;

  /// Receives, runs a tick if it is due, and sends. No effect on a server with a thread.
  void step();

  /// For a client in this program.
  ServerAddress address() const;
  /// Public key of the server.
  CryptoKey identity() const;
  /// Number of connected clients, each with one player or several.
  std::size_t clients() const;
  /// Whether rounds have no time limit (Match::waits).
  bool waits() const;
  /// Whether times may become best times (Match::countTimes).
  void countTimes(bool count);
  /// The players of this program are in these slots: only their times outlast the server (Match::keepTimesOf).
  void keepTimesOf(const SlotsByLocal& slots);
  /// Starts the next level at once.
  void startNextLevel();

 private:
  struct Running;
  std::unique_ptr<Running> running_;
};

}  // namespace platon
