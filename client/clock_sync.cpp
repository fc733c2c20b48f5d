#include "client/clock_sync.h"

#include <algorithm>
#include <cmath>

#include "shared/game/game.h"

namespace platon {

namespace {

double ticksOf(Moment moment) { return toSeconds(moment) * kTicksPerSecond; }

}  // namespace

ClockSync::ClockSync(double tick, Moment now)
    : now_(now), tick_(tick), lead_(tick - ticksOf(now)), targetLead_(lead_) {
  remember(tick - 1, tick);
}

void ClockSync::update(Moment now) {
  const double elapsed = ticksOf(now - now_);
  const double missing = targetLead_ - lead_;
  const bool jumps = mayJump(missing);
  lead_ += jumps ? missing : std::clamp(missing, -kMaxSlew * elapsed, kMaxSlew * elapsed);
  jumps_ += jumps ? 1 : 0;
  const double before = tick_;
  now_ = now;
  tick_ = ticksOf(now) + lead_;
  // The inputs that a jump passes over go out late whatever the line is like.
  remember(jumps ? std::max(before, tick_ - 1) : before, tick_);
}

bool ClockSync::mayJump(double error) const {
  // Behind by more than a tick means that inputs come too late: while nothing is known yet, waiting is worse.
  const bool settling = reports_ > 0 && reports_ <= kSettlingReports && error > 1.0;
  return settling || std::abs(error) > kJumpTicks;
}

void ClockSync::remember(double from, double to) {
  const auto first = static_cast<std::int64_t>(std::max(std::floor(from) + 1, std::floor(to) + 1 - double{kHistory}));
  const auto last = static_cast<std::int64_t>(std::floor(to));
  for (std::int64_t tick = std::max<std::int64_t>(first, 0); tick <= last; ++tick) {
    history_[static_cast<std::size_t>(tick) % kHistory] = {static_cast<std::uint32_t>(tick), true, lead_};
  }
}

void ClockSync::report(std::uint32_t tick, std::int32_t slack) {
  const Led& led = history_[tick % kHistory];
  if (!led.known || led.tick != tick) return;
  samples_[reports_ % kWindow] = led.lead - slack;
  ++reports_;
  targetLead_ = quantile(0.99) + kSpareTicks;
}

double ClockSync::quantile(double share) const {
  const std::size_t count = std::min<std::size_t>(reports_, kWindow);
  std::array<double, kWindow> sorted = samples_;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(count))) - 1;
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.begin() + static_cast<std::ptrdiff_t>(count));
  return sorted[static_cast<std::size_t>(rank)];
}

double ClockSync::error() const { return lead_ - targetLead_; }

double ClockSync::jitterTicks() const { return reports_ == 0 ? 0.0 : quantile(0.99) - quantile(0.5); }

}  // namespace platon
