#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/net/message_link.h"
#include "client/time/clock.h"
#include "protocol/to_client.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// What a server in this program plays, and for whom.
struct EmbeddedSettings {
  std::vector<std::string> levels{};  ///< files, in the order in which they are played; empty: the shipped levels
  bool listens = false;               ///< to the network; otherwise nobody else can join
  std::string bind = "::";            ///< address on which it listens; "::": all
  std::uint16_t port = kDefaultPort;  ///< of the network; 0: any that is free
  std::string password{};             ///< empty: none
  std::uint32_t maxPlayers = 16;      ///< 1 … kMaxPlayers
  bool waitsForOne = false;           ///< as MatchSettings::waitsForOne
  bool stepped = false;               ///< also a server that listens has no thread, and runs in OwnServer::step
};

/// The server of a match in this program.
class OwnServer {
 public:
  virtual ~OwnServer() = default;

  /// Receives, runs the ticks that are due, and sends. No effect on a server with a thread.
  virtual void step() = 0;
  /// The links of the client in this program, which must not outlive the server.
  virtual ServerLinks links() = 0;
  /// What that client knows of it.
  virtual ServerKnowledge knowledge() const = 0;
  /// The port on which others join; nothing: nobody else can.
  virtual std::optional<std::uint16_t> port() const = 0;
  /// Number of connected clients, each with one player or several.
  virtual std::size_t clients() const = 0;
  /// Whether rounds have no time limit (Match::waits).
  virtual bool waits() const = 0;
  /// Whether times may become best times (Match::countTimes).
  virtual void countTimes(bool count) = 0;
  /// The players of this program are in these slots: only their times outlast the server (Match::keepTimesOf).
  virtual void keepTimesOf(const SlotsByLocal& slots) = 0;
  /// Starts the next level at once.
  virtual void startNextLevel() = 0;
};

/// Starts a server: an EmbeddedServer if it listens, else one for the clients of this program alone, which has neither
/// a thread nor a socket. Throws ProgramError. When the file of its only level changes, a new round plays it. If it is
/// invalid, the old level stays, and a notice and stderr say why. The server goes by `clock`.
std::unique_ptr<OwnServer> startServer(const EmbeddedSettings& settings,
                                       const std::shared_ptr<const PausableClock>& clock);

/// A dedicated server in this program, in a thread of its own unless it is stepped.
class EmbeddedServer final : public OwnServer {
 public:
  /// As startServer; also throws ProgramError if the port is taken. Without `clock` it goes by the clock of the system.
  /// It has the identity of the user's other servers.
  explicit EmbeddedServer(const EmbeddedSettings& settings,
                          const std::shared_ptr<const PausableClock>& clock = nullptr);
  /// Stops the server.
  ~EmbeddedServer() override;
  EmbeddedServer(const EmbeddedServer&) = delete;
  EmbeddedServer& operator=(const EmbeddedServer&) = delete;

  void step() override;
  ServerLinks links() override;
  ServerKnowledge knowledge() const override;
  std::optional<std::uint16_t> port() const override;
  /// For a client on this machine.
  ServerAddress address() const;
  std::size_t clients() const override;
  bool waits() const override;
  void countTimes(bool count) override;
  void keepTimesOf(const SlotsByLocal& slots) override;
  void startNextLevel() override;

 private:
  struct Running;
  Password password_;
  std::unique_ptr<Running> running_;
};

}  // namespace platon
