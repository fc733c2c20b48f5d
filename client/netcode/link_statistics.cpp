#include "client/netcode/link_statistics.h"

#include "client/time/moment.h"
#include "platon/game/game.h"

namespace platon {

LinkStatistics readingOf(const LinkMeter& line, const ClockSync* clock, double slackTicks) {
  LinkStatistics reading;
  reading.rttMs = toSeconds(line.roundTrip()) * 1000;
  reading.lostDownPercent = line.lostDownPercent();
  reading.lostUpPercent = line.lostUpPercent();
  if (clock == nullptr) return reading;
  reading.jitterMs = clock->jitterTicks() * 1000 / kTicksPerSecond;
  reading.slackTicks = slackTicks;
  return reading;
}

}  // namespace platon
