#pragma once

#include <optional>
#include <string>

#include "client/connection.h"
#include "client/moment.h"
#include "client/server_address.h"
#include "client/session.h"

namespace platon {

/// A session over a connection. Knows for how long to wait for an answer and how to say what went wrong.
class NetworkClient {
 public:
  static constexpr Moment kPatience = std::chrono::seconds(5);

  /// Begins to connect to `server`, through `way` when the datagrams take another way. Throws std::runtime_error when
  /// that cannot even begin.
  NetworkClient(const ServerAddress& server, const std::string& name, Moment now,
                const std::optional<ServerAddress>& way = std::nullopt);

  /// Receives, predicts up to `now`, sends. To be called every few milliseconds.
  void update(Moment now, const Controls& controls);
  /// Says good-bye; `update` until `closed`.
  void leave();

  bool closed() const { return connection_.state() == Connection::State::kClosed; }
  /// Why the game is over, a sentence for the player; nothing while it goes on.
  const std::optional<std::string>& ending() const { return ending_; }

  /// Null until connected.
  const Session* session() const { return session_ ? &*session_ : nullptr; }
  /// What was last found wrong with the confirmed game; each is given once.
  std::optional<MismatchReport> takeMismatch();
  const Connection& connection() const { return connection_; }

 private:
  std::optional<std::string> findEnding(Moment now) const;

  ServerAddress server_;
  std::string name_;
  Connection connection_;
  std::optional<Session> session_;
  Moment waitingSince_;
  bool leaving_ = false;
  std::optional<std::string> ending_;
};

}  // namespace platon
