#include "client/netcode/link_meter.h"

#include "platon/game/game.h"
#include "protocol/time.h"

namespace platon {

namespace {

constexpr int kSmoothing = 8;

}  // namespace

std::uint8_t LinkMeter::nextSequence(Time now) {
  sentAt_[next_] = now;
  return next_++;
}

void LinkMeter::receive(const ConfirmedTicks& message, Time now) {
  down_.received(message.sequence);
  if (!message.link) return;
  const std::uint8_t reported = message.link->sequence;
  const auto pending = static_cast<std::uint8_t>(next_ - oldestPending_);
  // The number was reported by a message that overtook this one, or was never sent.
  if (static_cast<std::uint8_t>(reported - oldestPending_) >= pending) return;
  oldestPending_ = static_cast<std::uint8_t>(reported + 1);
  lostUp_ = message.link->lostPercent;
  const Time sample = now - sentAt_[reported];
  roundTrip_ = roundTrip_ == Time{} ? sample : roundTrip_ + (sample - roundTrip_) / kSmoothing;
}

LinkStatistics LinkMeter::statistics(const PredictionClock* clock) const {
  LinkStatistics statistics;
  statistics.rttMs = toSeconds(roundTrip_) * 1000;
  statistics.lostDownPercent = lostDownPercent();
  statistics.lostUpPercent = lostUp_;
  if (clock == nullptr) return statistics;
  statistics.jitterMs = clock->jitterTicks() * 1000 / kTicksPerSecond;
  statistics.slackTicks = clock->slack();
  return statistics;
}

}  // namespace platon
