#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "client/net/enet_link.h"
#include "client/netcode/link_meter.h"
#include "client/netcode/prediction.h"
#include "client/session/round.h"
#include "protocol/time.h"

namespace platon {

/// Result of one bot. `traffic` and `prediction` cover the measured time, which starts when the settling time after the
/// first confirmed tick is over; `prediction.maxSubunits` and all other fields cover the whole run.
struct BotResult {
  bool joined = false;
  std::optional<std::string> ending;  ///< why the bot ended early; empty if it played to the end
  double connectMs = 0;               ///< from the first datagram to the first confirmed tick
  LinkStatistics link;                ///< at the end
  std::uint32_t resumes = 0;          ///< how often the bot resumed its player after an outage
  double seconds = 0;                 ///< measured time; 0 if the settling time was not over
  Traffic traffic;
  PredictionStatistics prediction;  ///< of a hollow bot only `confirmedTicks`
  RoundStatistics round;            ///< zero for a hollow bot
};

/// Separates a bot's measured time from joining and settling.
class BotMeasure {
 public:
  /// The bot starts to connect at `now`. Its measured time starts `settle` after its first confirmed tick.
  BotMeasure(Time now, Time settle) : startedAt_(now), now_(now), settle_(settle) {}

  /// The bot's totals at `now`.
  void update(Time now, const PredictionStatistics& prediction, const Traffic& traffic);
  /// A result with `joined`, `connectMs`, `seconds`, `traffic` and `prediction` set.
  BotResult result(const PredictionStatistics& prediction, const Traffic& traffic) const;

 private:
  Time startedAt_;
  Time now_;
  Time settle_;
  std::optional<Time> playingSince_;
  std::optional<Time> measuredSince_;
  PredictionStatistics predictionBefore_;
  Traffic trafficBefore_;
};

/// Averages over the bots that played to the end; zero if there are none.
struct BotReport {
  std::uint32_t connected = 0;  ///< bots that played to the end
  std::uint32_t failed = 0;     ///< all others
  double connectMs = 0;
  double rttMs = 0;
  double jitterMs = 0;    ///< as LinkStatistics
  double slackTicks = 0;  ///< as LinkStatistics
  double downLossPercent = 0;
  double upLossPercent = 0;
  double downBytesPerSecond = 0;  ///< UDP payload
  double upBytesPerSecond = 0;
  double downPacketsPerSecond = 0;
  double upPacketsPerSecond = 0;
  double correctionsPer1000Ticks = 0;
  double maxCorrectionSubunits = 0;
  double mispredictedPer1000Ticks = 0;
  double missedInputsPer1000Ticks = 0;
  double desyncs = 0;
  double resyncs = 0;
  double confirmedTicks = 0;
  double resumes = 0;
  std::uint64_t longestDatagramBytes = 0;  ///< maximum of all bots over the whole run, UDP payload
  bool hollow = false;                     ///< hollow bots: statistics of the game are unknown
};

BotReport makeReport(std::span<const BotResult> bots);

/// One JSON object. Statistics that hollow bots do not know are null.
std::string toJson(const BotReport& report);
/// A human-readable table.
std::string toText(const BotReport& report);

}  // namespace platon
