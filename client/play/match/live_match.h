#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/lobby/reached_levels.h"
#include "client/play/client_options.h"
#include "client/play/match/attempt_speed.h"
#include "client/play/match/embedded_server.h"
#include "client/play/match/match_play.h"
#include "client/time/clock.h"
#include "protocol/transport/password.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// What to play.
struct MatchChoice {
  std::optional<ServerAddress> server{};  ///< nothing: a server in this program
  Password password{};                    ///< of that server
  std::optional<CryptoKey> key{};         ///< of that server, from a list; nothing: the one that the client remembers
  EmbeddedSettings own{};                 ///< of the server in this program
  std::filesystem::path rival{};          ///< a recording that runs as a ghost, whatever the settings; empty: none
};

/// A match and, unless it is on another server, the server that runs it. Both go by one clock, which stands still while
/// a player who is alone pauses.
class LiveMatch {
 public:
  /// Starts the server, if it is in this program, and starts to connect. Throws as MatchPlay and EmbeddedServer do.
  LiveMatch(const ClientOptions& options, const MatchChoice& choice, const Clock& clock);

  /// `wantsPause`: the match pauses as far as nobody else plays in it.
  void update(bool wantsPause, const Controls& controls);
  /// From now on, while nobody else plays on the server in this program, the game runs at this speed, 0.5 … 1. The
  /// time and the run of an attempt in which it was less than 1 count for nothing.
  void setSpeed(double speed);
  /// The least speed of the present attempt.
  double leastSpeed() const { return attempt_.least(); }
  /// Whether the game stands still.
  bool paused() const { return time_->paused(); }
  /// Whether the server is in this program and nobody else plays on it.
  bool alone() const { return server_ && server_->players() <= 1; }
  /// Whether a player who is alone has all the time it wants, and starts the next level itself: the server decides it.
  bool waits() const { return server_ && server_->waits(); }
  /// Time of the match: stands still in a pause.
  Moment now() const { return time_->now(); }
  /// Leads to the next level: at once for a player who is alone, else by a vote, or taking it back.
  void skipLevel();
  /// Leaves the match; takes at most half a second.
  void leave();

  /// Of the server in this program, for a client in this program.
  ServerAddress serverAddress() const { return server_->address(); }
  /// What to tell others so that they can join, a paragraph each; empty unless the server in this program listens to
  /// the network.
  std::vector<std::string> invitation() const;
  MatchPlay& play() { return *play_; }
  const MatchPlay& play() const { return *play_; }

 private:
  void applySpeed();
  void noteGoal();

  MatchChoice choice_;
  Clock clock_;
  double speed_ = 1;  // that is wanted
  AttemptSpeed attempt_;
  ReachedLevels reached_;
  std::optional<std::uint32_t> asked_;  // the round whose end the player who is alone has asked for
  std::shared_ptr<PausableClock> time_;
  std::optional<EmbeddedServer> server_;
  std::optional<MatchPlay> play_;
};

}  // namespace platon
