#include "client/netcode/link_statistics.h"

#include "platon/game/game.h"
#include "protocol/moment.h"

namespace platon {

LinkStatistics makeLinkStatistics(const LinkMeter& meter, const PredictionClock* clock) {
  LinkStatistics statistics;
  statistics.rttMs = toSeconds(meter.roundTrip()) * 1000;
  statistics.lostDownPercent = meter.lostDownPercent();
  statistics.lostUpPercent = meter.lostUpPercent();
  if (clock == nullptr) return statistics;
  statistics.jitterMs = clock->jitterTicks() * 1000 / kTicksPerSecond;
  statistics.slackTicks = clock->slack();
  return statistics;
}

}  // namespace platon
