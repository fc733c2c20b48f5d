#pragma once

#include "client/netcode/link_meter.h"
#include "client/netcode/prediction_clock.h"

namespace platon {

/// Quality of a connection in display units.
struct LinkStatistics {
  double rttMs = 0;            ///< smoothed; includes the server's wait for its next tick and message
  double jitterMs = 0;         ///< of messages to the server: 99th percentile minus median of their lateness
  double slackTicks = 0;       ///< ticks by which the last reported input was early; negative: too late
  double lostDownPercent = 0;  ///< of the last hundred messages
  double lostUpPercent = 0;
};

/// `clock`: null while no round runs; jitter and slack are 0 then.
LinkStatistics makeLinkStatistics(const LinkMeter& meter, const PredictionClock* clock);

}  // namespace platon
