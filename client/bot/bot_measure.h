#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/net/connection.h"
#include "client/netcode/link_statistics.h"
#include "client/netcode/prediction.h"
#include "client/session/round.h"
#include "protocol/moment.h"

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
  BotMeasure(Moment now, Moment settle) : startedAt_(now), now_(now), settle_(settle) {}

  /// The bot's totals at `now`.
  void update(Moment now, const PredictionStatistics& prediction, const Traffic& traffic);
  /// A result with `joined`, `connectMs`, `seconds`, `traffic` and `prediction` set.
  BotResult result(const PredictionStatistics& prediction, const Traffic& traffic) const;

 private:
  Moment startedAt_;
  Moment now_;
  Moment settle_;
  std::optional<Moment> playingSince_;
  std::optional<Moment> measuredSince_;
  PredictionStatistics predictionBefore_;
  Traffic trafficBefore_;
};

}  // namespace platon
