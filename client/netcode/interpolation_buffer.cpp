#include "client/netcode/interpolation_buffer.h"

#include <algorithm>
#include <cmath>

namespace platon {

void InterpolationBuffer::restart(const Game& confirmed, std::uint32_t ticks) {
  jumps_ += clock_ ? 1 : 0;
  clock_.reset();
  oldest_ = newest_ = arrived_ = ticks;
  keepNewest(confirmed);
}

void InterpolationBuffer::advanced(const Game& confirmed) {
  ++newest_;
  oldest_ = std::max(oldest_, newest_ < kMaxSnapshots ? 0 : newest_ - kMaxSnapshots + 1);
  keepNewest(confirmed);
}

void InterpolationBuffer::keepNewest(const Game& confirmed) {
  std::vector<PlayerSnapshot>& players = at(newest_);
  players.clear();
  for (std::uint32_t slot = 0; slot < confirmed.slots(); ++slot) players.push_back(snapshotOf(confirmed, slot));
}

void InterpolationBuffer::arrived(Time now) {
  if (newest_ == arrived_) return;
  const bool stalled = newest_ - arrived_ > kJumpTicks;
  // Older ticks were held back by a restart or a stall, so their lateness does not describe the connection.
  if (stalled || !clock_) arrived_ = newest_ - 1;
  measure(now);
  if (clock_ && !stalled) return clock_->setTarget(targetLead());
  jumps_ += clock_ ? 1 : 0;
  startClock(now);
}

void InterpolationBuffer::measure(Time now) {
  while (arrived_ != newest_) lateness_.add(toTicks(now) - ++arrived_);
  minLateness_ = lateness_.quantile(0);
  delay_ = std::min(lateness_.quantile(0.99) - minLateness_ + 1 + kSpareTicks, double{1} * kMaxDelay);
}

void InterpolationBuffer::startClock(Time now) {
  const double target = toTicks(now) + targetLead();
  clock_.emplace(std::clamp(target, double{1} * oldest_, double{1} * newest_), now, kMaxSlew, kJumpTicks);
  clock_->setTarget(targetLead());
}

void InterpolationBuffer::update(Time now) {
  if (!clock_) return;
  jumps_ += clock_->update(now) ? 1 : 0;
  clock_->holdAt(newest_);
}

double InterpolationBuffer::tick() const {
  return clock_ ? std::clamp(clock_->tick(), double{1} * oldest_, double{1} * newest_) : newest_;
}

InterpolatedPlayers InterpolationBuffer::players() const {
  if (oldest_ == newest_) return {at(newest_), at(newest_), 0};
  const double shown = tick();
  const std::uint32_t before = std::min(static_cast<std::uint32_t>(std::floor(shown)), newest_ - 1);
  return {at(before), at(before + 1), shown - before};
}

}  // namespace platon
