#include "client/netcode/clock_sync.h"

#include <algorithm>
#include <cmath>

namespace platon {

ClockSync::ClockSync(double tick, Moment now) : clock_(tick, now, kMaxSlew, kJumpTicks) { remember(tick - 1, tick); }

void ClockSync::update(Moment now) {
  const double before = tick();
  const bool jumped = clock_.update(now, mayJump());
  // The inputs that a jump passes over go out late whatever the line is like.
  remember(jumped ? std::max(before, tick() - 1) : before, tick());
}

// Behind means that inputs come too late: while little is known, waiting is worse.
bool ClockSync::mayJump() const { return settling() && error() < -kJumpWhileSettling; }

void ClockSync::expect(double tick) {
  if (reports_ == 0) clock_.setTarget(std::max(clock_.target(), clock_.lead() + tick - clock_.tick()));
}

void ClockSync::remember(double from, double to) {
  const auto first = static_cast<std::int64_t>(std::max(std::floor(from) + 1, std::floor(to) + 1 - double{kHistory}));
  const auto last = static_cast<std::int64_t>(std::floor(to));
  for (std::int64_t tick = std::max<std::int64_t>(first, 0); tick <= last; ++tick) {
    history_[static_cast<std::size_t>(tick) % kHistory] = {static_cast<std::uint32_t>(tick), true, clock_.lead()};
  }
}

void ClockSync::report(std::uint32_t tick, std::int32_t slack) {
  const Led& led = history_[tick % kHistory];
  if (!led.known || led.tick != tick) return;
  samples_.add(led.lead - slack);
  ++reports_;
  const double target = samples_.quantile(0.99) + kSpareTicks;
  clock_.setTarget(settling() ? std::max(target, clock_.lead()) : target);
}

double ClockSync::jitterTicks() const {
  return samples_.empty() ? 0.0 : samples_.quantile(0.99) - samples_.quantile(0.5);
}

}  // namespace platon
