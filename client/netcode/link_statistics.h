#pragma once

#include "client/netcode/clock_sync.h"
#include "client/netcode/link_meter.h"

namespace platon {

/// How a line does, for people.
struct LinkStatistics {
  double rttMs = 0;            ///< smoothed; with what the server waits for its next tick and its next message
  double jitterMs = 0;         ///< of what goes up: 99th percentile less median; 0 while there is no clock
  double slackTicks = 0;       ///< by which an own input last came before it was needed; negative: too late
  double lostDownPercent = 0;  ///< of the last hundred messages
  double lostUpPercent = 0;
};

/// `clock`: null while there is none.
LinkStatistics readingOf(const LinkMeter& line, const ClockSync* clock, double slackTicks);

}  // namespace platon
