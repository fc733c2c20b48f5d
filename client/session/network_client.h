#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/net/connection.h"
#include "client/net/server_address.h"
#include "client/session/session.h"
#include "client/time/moment.h"

namespace platon {

/// Sessions with one server over connections to it. Knows for how long to wait for an answer and how to say what went
/// wrong. A player who was once let in and loses the connection is taken back: the server is asked again at once, and
/// goes on being asked (`Connection::kBetweenCalls`) until it answers. One that answers but does not let the client in,
/// as it is full, is asked ever less often.
class NetworkClient {
 public:
  /// Until when a server that is asked must have answered, and one that is greeted must have let the client in: where
  /// much is lost a greeting takes some repetitions.
  static constexpr Moment kPatience = std::chrono::seconds(5);
  static constexpr Moment kGreetingPatience = std::chrono::seconds(8);
  /// After the second answer that does not let the client in; doubled each time up to kLongestPause.
  static constexpr Moment kFirstPause = std::chrono::milliseconds(250);
  static constexpr Moment kLongestPause = std::chrono::seconds(2);
  /// Attempts to get in at first, where a server is heard of at all.
  static constexpr std::uint32_t kFirstAttempts = 3;

  /// Begins to connect to `server`, through `way` when the datagrams take another way. `token`: of a player that was
  /// lost; without one a fresh token. Throws std::runtime_error when that cannot even begin.
  NetworkClient(const ServerAddress& server, const std::string& name, Moment now,
                const std::optional<ServerAddress>& way = std::nullopt,
                const std::optional<SessionToken>& token = std::nullopt);

  /// Receives, predicts up to `now`, sends. To be called every few milliseconds.
  void update(Moment now, const Controls& controls);
  /// Says good-bye; `update` until `closed`. That is at once when there is nobody to say it to.
  void leave();

  /// Whether there is no connection, nor one being made.
  bool closed() const { return !connection_ || connection_->state() == Connection::State::kClosed; }
  /// Why the game is over for good, a sentence for the player; nothing while it goes on.
  const std::optional<std::string>& ending() const { return ending_; }
  /// Why there is no game at the moment, a sentence for the player; from when it was lost until it goes on.
  const std::optional<std::string>& outage() const { return outage_; }
  /// How often a lost game went on.
  std::uint32_t resumes() const { return resumes_; }

  /// The secret that takes back the player. Not to be shown.
  const SessionToken& token() const { return *memory_.token; }
  /// Whether the server has let the client in, ever.
  bool welcomed() const { return welcomed_; }

  /// Null until connected. After a loss, the last session until there is a new connection.
  const Session* session() const { return session_ ? &*session_ : nullptr; }
  /// What was last found wrong with the confirmed game; each is given once.
  std::optional<DesyncReport> takeDesync();
  /// Over all connections.
  Traffic traffic() const;

 private:
  void connect(Moment now);
  void greet(Moment now);
  void watch(Moment now);
  std::optional<Session::Ending> trouble(Moment now) const;
  void lose(const Session::Ending& trouble, Moment now);
  bool mayRetry(const Session::Ending& trouble) const;
  Moment pauseAfterLoss();
  void drop();
  void forward();

  ServerAddress server_;
  ServerAddress way_;
  Session::Memory memory_;  // for the next session
  std::string name_;
  std::optional<Connection> connection_;
  std::optional<Session> session_;
  bool greeted_ = false;        // session_ is over connection_
  Moment waitingSince_;         // connecting, or greeted
  bool welcomed_ = false;       // ever
  std::uint32_t attempts_ = 0;  // that have failed since there was a game
  std::uint32_t answers_ = 0;   // those that were not just unanswered
  std::optional<Moment> retryAt_;
  std::optional<std::string> outage_;
  std::uint32_t resumes_ = 0;
  Traffic before_;  // of the connections before
  bool leaving_ = false;
  std::optional<std::string> ending_;
};

}  // namespace platon
