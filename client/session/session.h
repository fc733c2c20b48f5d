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
#include "client/netcode/link_statistics.h"
#include "client/session/round.h"
#include "client/time/moment.h"
#include "platon/game/level.h"
#include "protocol/assembly.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

/// A message for the server, encoded.
struct OutgoingMessage {
  std::vector<std::uint8_t> bytes;
  bool reliable = false;  ///< on the reliable channel; else unsequenced on the tick channel
};

/// A client's whole part in a match, from Hello to Bye: greets, fetches levels, plays the rounds, knows who else is
/// there. Has no socket and no clock: what arrives is handed in, what is to be sent is taken out, and the time is told.
class Session {
 public:
  /// What is worth keeping of a session for the next one with the same server.
  struct Memory {
    std::optional<SessionToken> token;  ///< a fresh one, if this is the first session; without, no way back
    std::vector<std::shared_ptr<const Level>> levels;  ///< at most kMaxLevelsKnown, newest last
    PredictionStatistics prediction;
    RoundStatistics rounds;
  };

  /// Why a session is over.
  struct Ending {
    std::string reason;    ///< a sentence for the player
    bool forGood = false;  ///< trying again is of no use
  };

  /// A server that has welcomed the client but says nothing for this long has gone.
  static constexpr Moment kSilence = std::chrono::seconds(4);
  /// Of desyncs that come faster, only the first is reported; all are counted.
  static constexpr Moment kBetweenReports = std::chrono::minutes(1);

  /// `name` is a clean label of at most kMaxNameBytes, perhaps empty. `now`: when the connection was made. `memory`:
  /// takes back the player of the session before and goes on with its counts.
  Session(const std::string& name, Moment now, Memory memory = {});

  /// A message from the server. One that makes no sense ends the session.
  void receive(std::span<const std::uint8_t> bytes, Moment now);
  /// Predicts up to `now` and tells the server. To be called every few milliseconds.
  void update(Moment now, const Controls& controls);
  /// Says good-bye; the connection may be closed once this is sent.
  void leave();
  /// The connection is gone for this reason.
  void lose(std::string reason);
  /// What has to be sent, oldest first; each is given once.
  std::vector<OutgoingMessage> takeOutgoing();

  /// Nothing while it goes on.
  const std::optional<Ending>& ending() const { return ending_; }
  Memory memory() const { return {token_, levels_, predictionStatistics(), roundStatistics()}; }

  /// The own slot and the server's name, once welcomed.
  const std::optional<Welcome>& welcome() const { return welcome_; }
  /// The round that is played, once its level is there. Rounds differ by their id.
  const Round* round() const { return round_ ? &*round_ : nullptr; }
  /// Names by slot; empty where nobody plays.
  std::span<const std::string> names() const { return names_; }

  /// What was last found wrong with the confirmed game; each is given once.
  std::optional<DesyncReport> takeDesync() { return std::exchange(desync_, std::nullopt); }

  LinkStatistics reading() const;

  /// Over all rounds, those of the sessions before included.
  PredictionStatistics predictionStatistics() const;
  RoundStatistics roundStatistics() const;

 private:
  template <class Message>
  void send(const Message& message, bool reliable);
  void end(std::string reason, bool forGood);
  void keep(std::optional<Desync> desync);

  void handle(const Welcome& message, Moment now);
  void handle(const Refused& message, Moment now);
  void handle(const LevelChunk& message, Moment now);
  void handle(const StateChunk& message, Moment now);
  void handle(const Roster& message, Moment now);
  void handle(const RoundStart& message, Moment now);
  void handle(const RoundEnd& message, Moment now);
  void handle(const Bye& message, Moment now);
  void handle(const ConfirmedTicks& message, Moment now);

  std::shared_ptr<const Level> level(std::uint64_t hash) const;
  void fetch(std::uint64_t levelHash);
  void startRound(std::uint32_t round, std::uint64_t levelHash);
  void closeRound();

  Moment helloAt_;
  Moment heardAt_;
  std::optional<Ending> ending_;
  LinkMeter line_;
  std::optional<Welcome> welcome_;
  std::vector<std::string> names_;
  std::vector<OutgoingMessage> outgoing_;

  std::optional<SessionToken> token_;
  std::vector<std::shared_ptr<const Level>> levels_;  // the last few, newest last
  std::optional<std::uint64_t> fetching_;             // hash of the level on its way
  Assembly levelText_;
  Assembly state_;

  std::optional<RoundStart> next_;  // waits for its level
  std::optional<Round> round_;
  double lead_ = 0;
  std::optional<DesyncReport> desync_;
  std::optional<Moment> desyncAt_;       // when the last was reported
  PredictionStatistics pastPrediction_;  // of the rounds before
  RoundStatistics pastRounds_;
};

}  // namespace platon
