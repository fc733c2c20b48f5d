#include "client/line_reading.h"

#include "client/moment.h"
#include "shared/game/game.h"

namespace platon {

LineReading readingOf(const LineMeter& line, const ClockSync* clock, double slackTicks) {
  LineReading reading;
  reading.rttMs = toSeconds(line.roundTrip()) * 1000;
  reading.lostDownPercent = line.lostDownPercent();
  reading.lostUpPercent = line.lostUpPercent();
  if (clock == nullptr) return reading;
  reading.jitterMs = clock->jitterTicks() * 1000 / kTicksPerSecond;
  reading.slackTicks = slackTicks;
  return reading;
}

}  // namespace platon
