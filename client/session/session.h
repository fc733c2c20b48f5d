#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/desync/desync_report.h"
#include "client/session/dialogue.h"
#include "client/session/known_levels.h"
#include "client/session/round.h"
#include "client/session/talk.h"
#include "client/session/work_limit.h"
#include "platon/game/level.h"
#include "protocol/time.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

/// Names of the companions by local number; nothing: there is none. The one of local number 0 is never set.
using NamesByLocal = std::array<std::optional<std::string>, kMaxLocalPlayers>;

/// The client's side of a match over one connection, from Hello to Bye: each message goes to the part that it concerns,
/// and a round begins as soon as its level is known. A session has no socket and no clock: the caller passes received
/// messages and the time, and takes the messages to send.
class Session {
 public:
  /// State that the next session with the same server continues with.
  struct Memory {
    std::optional<SessionToken> token;  ///< identifies the players to resume; without one they cannot be resumed
    NamesByLocal companions;            ///< who plays besides the player of Hello
    std::vector<std::shared_ptr<const Level>> levels;  ///< at most kMaxLevelsKnown, newest last
    PredictionStatistics prediction;
    RoundStatistics rounds;
    std::shared_ptr<LevelStore> store;            ///< levels of this server that are kept elsewhere; null: none
    std::shared_ptr<ConfirmedObserver> observer;  ///< follows the confirmed game; null: none
  };

  /// A session ends if it receives nothing for this long after Welcome.
  static constexpr Time kTimeout = std::chrono::seconds(4);

  /// `name`: a valid label of at most kMaxNameBytes; may be empty. `now`: when the connection was established.
  /// `memory`: of the previous session, whose player and statistics this one resumes.
  Session(const std::string& name, Time now, Memory memory = {});

  /// Handles a message from the server. A malformed message ends the session.
  void receive(std::span<const std::uint8_t> bytes, Time now);
  /// Predicts up to `now` and queues a message to the server when one is due. Call every few milliseconds.
  void update(Time now, const Controls& controls);
  /// Wishes that the next level follows at once, or takes this wish back. The wish ends with the round and with the
  /// session. No effect without a round, and when it is over.
  void toggleVote();
  /// A local player says a text or an emote to all players, as soon as the server passes it on. `chat`: isChat. Returns
  /// false, without effect, before Welcome, after the end, and when the server would drop it because this client has
  /// said too much.
  bool say(const Chat& chat, Time now, std::uint32_t local = 0);
  /// A companion with this name (Hello::name) is to play under a local number from 1 on, or takes the name; nothing: it
  /// leaves. It plays once `slots` has it; if the server refuses it, takeNotice tells why. It comes again with each
  /// session that resumes this one. No effect after the end.
  void setCompanion(std::uint32_t local, const std::optional<std::string>& name);
  /// Queues a Leave message. The connection may be closed once it is sent.
  void leave();
  /// Ends the session because its connection was lost.
  void connectionLost(std::string reason);
  /// Queued messages, oldest first; each is returned once.
  std::vector<OutgoingMessage> takeOutgoing() { return dialogue_.takeOutgoing(); }

  /// Why the session has ended; empty while it runs.
  const std::optional<SessionEnding>& ending() const { return dialogue_.ending(); }
  Memory memory() const;

  /// Slot of the first local player and server name; empty until the server has accepted the client.
  const std::optional<Welcome>& welcome() const { return dialogue_.welcome(); }
  /// Of all local players; none before Welcome.
  const SlotsByLocal& slots() const { return slots_; }
  /// Who is to play besides the first local player.
  const NamesByLocal& companions() const { return companions_; }
  /// The current round; null until its level has been received.
  const Round* round() const { return round_ ? &*round_ : nullptr; }
  /// How the current round ended and what comes next; null while the server has not ended it. The server can do so
  /// before the game is over: it does not wait for players that are inactive or disconnected, and players may vote.
  const RoundEnd* roundEnd() const;
  /// How many players wish the next level in this round. Without `votes`, `voters` means nothing.
  const VoteCount& voteCount() const { return voteCount_; }
  /// Whether the players of this client wish it.
  bool wishesNext() const { return wishesNext_; }
  /// Player names by slot; an empty name means a free slot.
  std::span<const std::string> names() const { return talk_.names(); }
  /// Round trip between the server and the player of a slot (Talk::roundTripMs).
  std::optional<std::uint32_t> roundTripMs(std::uint32_t slot, Time now) const { return talk_.roundTripMs(slot, now); }
  /// The newest text of the server, which a player can see: of its operator, or why it refuses a companion. Each is
  /// returned once.
  std::optional<std::string> takeNotice() { return talk_.takeNotice(); }
  /// What players have said, oldest first; each is returned once. At most Talk::kMaxChats are kept.
  std::vector<PlayerChat> takeChats() { return talk_.takeChats(); }
  /// The last desync report; each is returned once.
  std::optional<DesyncReport> takeDesync() { return desyncs_.take(); }

  LinkStatistics linkStatistics() const;
  /// Totals of all rounds, those of previous sessions included.
  PredictionStatistics predictionStatistics() const;
  RoundStatistics roundStatistics() const;

 private:
  void handle(const Welcome& message, Time now);
  void handle(const Refused& message, Time now);
  void handle(const Bye& message, Time now);
  void handle(const LevelChunk& message, Time now);
  void handle(const RoundStart& message, Time now);
  void handle(const ConfirmedTicks& message, Time now);
  void handle(const StateChunk& message, Time now);
  void handle(const VoteCount& message, Time now);
  void handle(const RoundEnd& message, Time now);
  void handle(const LocalSlots& message, Time now);
  void handle(const auto& message, Time now) { talk_.receive(message, now); }

  void sendCompanion(std::uint32_t local);
  void forgetCompanions(const LocalSlots& message);
  void startRound(RoundStart start);
  void closeRound();
  void requestLevel(std::uint64_t hash);
  void prefetch();
  void reportLastDesync();

  std::optional<SessionToken> token_;
  std::shared_ptr<ConfirmedObserver> observer_;  // null: none
  NamesByLocal companions_;
  SlotsByLocal slots_;
  KnownLevels levels_;
  Dialogue dialogue_;
  Talk talk_;
  WorkLimit work_;
  DesyncReports desyncs_;

  std::optional<RoundStart> pendingRound_;  // waits for its level
  std::optional<Round> round_;
  std::optional<RoundEnd> roundEnd_;  // the last one
  VoteCount voteCount_;
  bool wishesNext_ = false;
  double lead_ = 0;                      // with which the next round begins
  PredictionStatistics pastPrediction_;  // of earlier rounds
  RoundStatistics pastRounds_;
};

}  // namespace platon
