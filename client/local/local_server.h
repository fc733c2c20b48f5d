#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "client/net/message_link.h"
#include "protocol/time.h"
#include "server/base/tick_clock.h"
#include "server/match/match.h"

namespace platon {

/// A link to a server in this program. What is sent arrives when the server is updated.
class LocalLink final : public MessageLink {
 public:
  /// The messages on their way, and which end has closed.
  struct Way {
    std::vector<std::vector<std::uint8_t>> toServer;
    std::vector<std::vector<std::uint8_t>> toClient;
    bool clientEnds = false;
    bool serverEnds = false;
  };

  explicit LocalLink(std::shared_ptr<Way> way) : way_(std::move(way)) {}
  ~LocalLink() override { way_->clientEnds = true; }

  void service(Time now, const Receiver& receiver) override;
  void flush(Time /*now*/) override {}
  void send(std::span<const std::uint8_t> message, bool reliable) override;
  void close() override { way_->clientEnds = true; }

  State state() const override { return isClosed_ ? State::kClosed : State::kConnected; }
  /// Nobody is refused.
  const std::optional<Refused>& refused() const override { return refused_; }
  /// There is nobody who could take its place.
  std::optional<CryptoKey> identity() const override { return std::nullopt; }
  /// Nothing leaves the program.
  Traffic traffic() const override { return {}; }

 private:
  std::shared_ptr<Way> way_;
  std::optional<Refused> refused_;
  bool isClosed_ = false;
};

/// A match in this program without threads and sockets: its caller lets time pass.
class LocalServer {
 public:
  /// `levels` must not be empty. `times` must outlive the server; null: there are no best times. `now`: by the clock of
  /// the server.
  LocalServer(const MatchSettings& settings, std::vector<LevelPointer> levels, BestTimeKeeper* times, Time now);

  /// The links to it; those that are connected may outlive it.
  ServerLinks links();
  /// Takes what was sent, runs the ticks that are due at `now`, which never decreases, and sends. A long pause is made
  /// up for as TickClock says.
  void update(Time now);

  const Match& match() const { return match_; }
  Match& match() { return match_; }

 private:
  void receive();
  void send();

  Match match_;
  TickClock clock_;
  std::map<ClientId, std::shared_ptr<LocalLink::Way>> ways_;
  ClientId last_ = 0;
};

}  // namespace platon
