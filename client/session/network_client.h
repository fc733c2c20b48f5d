#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/net/message_link.h"
#include "client/session/session.h"
#include "client/time/clock.h"
#include "protocol/time.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Runs sessions with one server over links to it. When the link of an accepted client is lost, reconnects at once to
/// resume the players, and tries again until the server answers. If the server answers but does not accept the client,
/// for example because it is full, the pauses between attempts grow.
class NetworkClient {
 public:
  /// Who joins, and what it knows of the server.
  struct Profile {
    std::string name;
    ServerKnowledge knowledge{};
    std::optional<SessionToken> token{};            ///< of the players to resume; if not given, a random one
    std::shared_ptr<LevelStore> levels{};           ///< of this server; null: levels are kept in memory only
    std::shared_ptr<ConfirmedObserver> observer{};  ///< follows the confirmed games; null: none
  };

  /// Maximum time for the connection to be established.
  static constexpr Time kConnectTimeout = std::chrono::seconds(5);
  /// Maximum time from Hello to Welcome; long enough for several retransmissions.
  static constexpr Time kWelcomeTimeout = std::chrono::seconds(8);
  /// Pause after the second attempt that the server answered; doubled with each further one up to kMaxPause.
  static constexpr Time kFirstPause = std::chrono::milliseconds(250);
  static constexpr Time kMaxPause = std::chrono::seconds(2);
  /// Attempts to join for the first time, if the server answers connection requests.
  static constexpr std::uint32_t kMaxFirstAttempts = 3;

  /// Starts to connect. Throws as ServerLinks::connect does.
  NetworkClient(ServerLinks links, const Profile& profile, Time now);

  /// Receives, predicts up to `now` and sends. Call every few milliseconds.
  void update(Time now, const Controls& controls);
  /// Wishes the next level, or takes this wish back (Session::toggleVote). No effect without a session.
  void toggleVote();
  /// Says something to all players (Session::say). Returns false without a session.
  bool say(const Chat& chat, Time now, std::uint32_t local = 0) {
    return is<InSession>() && session_->say(chat, now, local);
  }
  /// Another player of this program joins, takes another name, or leaves (Session::setCompanion), now or as soon as
  /// there is a session.
  void setCompanion(std::uint32_t local, const std::optional<std::string>& name);
  /// Who is to play besides the first local player.
  const NamesByLocal& companions() const { return is<InSession>() ? session_->companions() : memory_.companions; }
  /// Leaves the match. Keep calling `update` until `closed`. Closes at once if there is no session.
  void leave();

  /// Whether there is no connection, established or in progress.
  bool closed() const { return !link_ || link_->state() == MessageLink::State::kClosed; }
  /// Why the match has ended permanently, a sentence for the player; empty until then.
  const std::optional<std::string>& ending() const { return ending_; }
  /// The server where the player can go on after the end, as the server has told; nothing if it has told none.
  std::optional<ServerAddress> next() const;
  /// Whether the match has ended because the server asks for a password, or for another one.
  bool asksPassword() const { return asksPassword_; }
  /// Why the match is interrupted, or why the server refuses to let the player go on, a sentence for the player; empty
  /// while it is not.
  const std::optional<std::string>& outage() const { return recovery_.outage; }
  /// How often the client resumed its players or rejoined after an outage.
  std::uint32_t resumes() const { return resumes_; }

  /// The secret that identifies the players to resume. Do not log it.
  const SessionToken& token() const { return *memory_.token; }
  /// Whether the server has ever accepted the client.
  bool welcomed() const { return welcomed_; }

  /// The server's identity, once a connection to it was sealed. From then on, no other identity is accepted.
  const std::optional<CryptoKey>& identity() const { return profile_.knowledge.identity; }

  /// The session; null before the first connection. During an outage, the last session.
  const Session* session() const { return session_ ? &*session_ : nullptr; }
  /// The newest text of the server's operator; each is returned once.
  std::optional<std::string> takeNotice() { return session_ ? session_->takeNotice() : std::nullopt; }
  /// What players have said (Session::takeChats).
  std::vector<PlayerChat> takeChats() { return session_ ? session_->takeChats() : std::vector<PlayerChat>(); }
  /// The last desync report; each is returned once.
  std::optional<DesyncReport> takeDesync();
  /// Total of all connections.
  Traffic traffic() const;

 private:
  struct Connecting {
    Time since;
  };
  // session_ runs over link_.
  struct InSession {
    Time since;
  };
  // There is no connection.
  struct Paused {
    Time until;
  };
  // ending_ is set. The connection of the last session may still be open.
  struct Ended {};
  struct Leaving {};

  // Attempts to connect since the match was last played.
  struct Recovery {
    std::optional<std::string> outage;
    std::uint32_t failed = 0;
    std::uint32_t answered = 0;  // of the failed ones, those that the server answered
  };

  template <class State>
  bool is() const {
    return std::holds_alternative<State>(state_);
  }
  void connect(Time now);
  void startSession(Time now);
  void checkConnecting(Time now);
  void checkSession(Time now);
  bool mayRetry(const SessionEnding& failure) const;
  bool isRefused() const;
  void fail(const SessionEnding& failure, Time now);
  Time pauseAfterFailure();
  void dropLink();
  void sendOutgoing();

  ServerLinks links_;
  Profile profile_;
  Session::Memory memory_;  // for the next session
  std::variant<Connecting, InSession, Paused, Ended, Leaving> state_;
  std::unique_ptr<MessageLink> link_;
  std::optional<Session> session_;
  Recovery recovery_;
  std::optional<std::string> ending_;
  bool asksPassword_ = false;
  bool welcomed_ = false;
  std::uint32_t resumes_ = 0;
  Traffic pastTraffic_;  // of earlier connections
};

/// Calls `update` every 2 ms until `closed` returns true, for half a second at most: the time that a Leave message gets
/// to reach the server.
void updateUntilClosed(const Clock& clock, const std::function<void(Time)>& update,
                       const std::function<bool()>& closed);

}  // namespace platon
