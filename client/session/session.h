#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/desync/desync_report.h"
#include "client/netcode/link_meter.h"
#include "client/netcode/prediction.h"
#include "client/session/level_store.h"
#include "client/session/outgoing_message.h"
#include "client/session/round.h"
#include "client/session/round_trip_list.h"
#include "platon/game/level.h"
#include "protocol/assembly.h"
#include "protocol/moment.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/token_bucket.h"

namespace platon {

/// The client's side of a match over one connection, from Hello to Bye: joins, downloads levels, plays the rounds and
/// keeps the roster. It has no socket and no clock: the caller passes received messages and the time, and takes the
/// messages to send.
class Session {
 public:
  /// State that the next session with the same server continues with.
  struct Memory {
    std::optional<SessionToken> token;  ///< identifies the player to resume; without one it cannot be resumed
    std::vector<std::shared_ptr<const Level>> levels;  ///< at most kMaxLevelsKnown, newest last
    PredictionStatistics prediction;
    RoundStatistics rounds;
    std::shared_ptr<LevelStore> store;            ///< levels of this server that are kept elsewhere; null: none
    std::shared_ptr<ConfirmedObserver> observer;  ///< follows the confirmed game; null: none
  };

  /// Why a session has ended.
  struct Ending {
    std::string reason;      ///< one sentence for the player
    bool permanent = false;  ///< reconnecting would fail too
    std::string next{};      ///< where the player can go on (isNextServer), perhaps empty
  };

  /// A session ends if it receives nothing for this long after Welcome.
  static constexpr Moment kTimeout = std::chrono::seconds(4);
  /// Largest number of levels that a session requests without receiving one. Beyond it, the session ends.
  static constexpr std::uint32_t kMaxUnansweredRequests = 16;
  /// Minimum time between two desync reports. Further desyncs are only counted.
  static constexpr Moment kReportInterval = std::chrono::minutes(1);

  /// Largest work per second that a server may demand (see Prediction::work): 30 replays of Prediction::kMaxWorkAhead,
  /// and 256 players for 120 ticks. A session that had to do more for kWorkTime ends.
  static constexpr double kMaxWorkPerSecond = 524'288;
  static constexpr Moment kWorkTime = std::chrono::seconds(5);
  /// A session also ends if for kWorkTime every update has much work and comes late after the one before: this computer
  /// cannot keep up, for instance because the level makes every player slow.
  static constexpr Moment kSlowUpdate = std::chrono::milliseconds(250);
  static constexpr std::uint64_t kSlowWork = 4096;

  /// Texts and emotes that wait to be taken; the oldest ones are dropped.
  static constexpr std::size_t kMaxChats = 64;

  /// `name`: a valid label of at most kMaxNameBytes; may be empty. `now`: when the connection was established.
  /// `memory`: of the previous session, whose player and statistics this one resumes.
  Session(const std::string& name, Moment now, Memory memory = {});

  /// Handles a message from the server. A malformed message ends the session.
  void receive(std::span<const std::uint8_t> bytes, Moment now);
  /// Predicts up to `now` and queues a message to the server when one is due. Call every few milliseconds.
  void update(Moment now, const Controls& controls);
  /// Wishes that the next level follows at once, or takes this wish back. The wish ends with the round and with the
  /// session. No effect without a round, and when it is over.
  void toggleVote();
  /// Says a text or an emote to all players, as soon as the server passes it on. `chat`: isChat. Returns false, without
  /// effect, before Welcome, after the end, and when the server would drop it because this client has said too much.
  bool say(const Chat& chat, Moment now);
  /// Queues a Leave message. The connection may be closed once it is sent.
  void leave();
  /// Ends the session because its connection was lost.
  void connectionLost(std::string reason);
  /// Queued messages, oldest first; each is returned once.
  std::vector<OutgoingMessage> takeOutgoing();

  /// Why the session has ended; empty while it runs.
  const std::optional<Ending>& ending() const { return ending_; }
  Memory memory() const { return {token_, levels_, predictionStatistics(), roundStatistics(), store_, observer_}; }

  /// Local slot and server name; empty until the server has accepted the client.
  const std::optional<Welcome>& welcome() const { return welcome_; }
  /// The current round; null until its level has been received.
  const Round* round() const { return round_ ? &*round_ : nullptr; }
  /// How the current round ended and what comes next; null while the server has not ended it. The server can do so
  /// before the game is over: it does not wait for players that are inactive or disconnected, and players may vote.
  const RoundEnd* roundEnd() const;
  /// How many players wish the next level in this round. Without `votes`, `voters` means nothing.
  const VoteCount& voteCount() const { return voteCount_; }
  /// Whether the player of this client wishes it.
  bool wishesNext() const { return wishesNext_; }
  /// Player names by slot; an empty name means a free slot.
  std::span<const std::string> names() const { return names_; }

  /// Round trip between the server and the player of a slot, milliseconds; nothing for a free slot, a disconnected
  /// player, and when the server has not told it lately, as to a player who is alone.
  std::optional<std::uint32_t> roundTripMs(std::uint32_t slot, Moment now) const;

  /// The newest text of the server's operator, which a player can see; each is returned once.
  std::optional<std::string> takeNotice() { return std::exchange(notice_, std::nullopt); }
  /// What players have said, oldest first; each is returned once. At most kMaxChats are kept.
  std::vector<PlayerChat> takeChats() { return std::exchange(chats_, {}); }
  /// The last desync report; each is returned once.
  std::optional<DesyncReport> takeDesync() { return std::exchange(desync_, std::nullopt); }

  LinkStatistics linkStatistics() const;
  /// Totals of all rounds, those of previous sessions included.
  PredictionStatistics predictionStatistics() const;
  RoundStatistics roundStatistics() const;

 private:
  template <class Message>
  void send(const Message& message, bool reliable);
  void end(std::string reason, bool permanent, const std::string& next = {});
  void reportDesync(std::optional<Desync> desync);

  void handle(const Welcome& message, Moment now);
  void handle(const Refused& message, Moment now);
  void handle(const LevelChunk& message, Moment now);
  void handle(const StateChunk& message, Moment now);
  void handle(const Roster& message, Moment now);
  void handle(const RoundStart& message, Moment now);
  void handle(const RoundEnd& message, Moment now);
  void handle(const Bye& message, Moment now);
  void handle(const Notice& message, Moment now);
  void handle(const VoteCount& message, Moment now);
  void handle(const PlayerChat& message, Moment now);
  void handle(const RoundTrips& message, Moment now);
  void handle(const ConfirmedTicks& message, Moment now);

  std::shared_ptr<const Level> level(std::uint64_t hash);
  void remember(std::shared_ptr<const Level> level);
  void prefetch();
  void requestLevel(std::uint64_t levelHash);
  void startRound(std::uint32_t round, std::uint64_t levelHash);
  void closeRound();
  std::uint64_t work() const { return pastWork_ + (round_ ? round_->prediction().work() : 0); }
  void checkWork(Moment now);

  Moment helloAt_;
  Moment receivedAt_;  // last message
  std::optional<Ending> ending_;
  LinkMeter linkMeter_;
  std::optional<Welcome> welcome_;
  std::vector<std::string> names_;
  RoundTripList roundTrips_;
  std::optional<std::string> notice_;
  std::vector<PlayerChat> chats_;
  TokenBucket chatBudget_;
  std::vector<OutgoingMessage> outgoing_;

  std::optional<SessionToken> token_;
  std::vector<std::shared_ptr<const Level>> levels_;  // at most kMaxLevelsKnown, newest last
  std::shared_ptr<LevelStore> store_;                 // null: none
  std::shared_ptr<ConfirmedObserver> observer_;       // null: none
  std::vector<std::uint64_t> announced_;              // levels that Hello has named
  std::optional<std::uint64_t> requestedLevel_;       // hash of the level being received
  std::uint32_t unanswered_ = 0;                      // requests since the last level
  Assembly levelText_;
  Assembly state_;

  std::optional<RoundStart> pendingRound_;  // waits for its level
  std::optional<Round> round_;
  std::optional<RoundEnd> roundEnd_;  // the last one
  VoteCount voteCount_;
  bool wishesNext_ = false;
  double lead_ = 0;
  TokenBucket workBudget_;
  std::uint64_t pastWork_ = 0;  // all but the prediction of this round
  std::uint64_t chargedWork_ = 0;
  Moment updatedAt_;
  Moment slowTime_{};  // of updates that came late one after the other
  std::optional<DesyncReport> desync_;
  std::optional<Moment> reportedAt_;     // last desync report
  PredictionStatistics pastPrediction_;  // of earlier rounds
  RoundStatistics pastRounds_;
};

}  // namespace platon
