#include "client/netcode/input_clock.h"

#include <algorithm>
#include <cmath>

#include "platon/game/game.h"
#include "protocol/limits.h"

namespace platon {

namespace {

constexpr double kFirstSpareTicks = 7;  // enough for 100 ms of jitter, of which nothing is known yet
// Between two updates: a quarter of a second. No line is to blame, and nobody shall be ahead by as much for ever after.
constexpr std::uint32_t kHiccupTicks = 15;
constexpr std::uint32_t kNotJudged = UINT32_MAX;

}  // namespace

double InputClock::firstLead(Moment greeting) { return toSeconds(greeting) * kTicksPerSecond + kFirstSpareTicks; }

void InputClock::receive(const ConfirmedTicks& message, Moment now) {
  const std::uint32_t newest = message.from + message.count;
  // While catching up a message does not tell how far the server is.
  if (message.count < kMaxTicksPerMessage) set(newest, now);
  if (sync_ && message.link && message.link->slack) judge(*message.link->slack);
  if (sync_ && sync_->reported()) lead_ = sync_->tick() - newest;
}

// The first message may have been a late one: until the server reports, the earliest of those that came counts.
void InputClock::set(std::uint32_t newest, Moment now) {
  if (sync_) return sync_->expect(newest + lead_);
  sync_.emplace(newest + lead_, now);
  firstInput_ = static_cast<std::uint32_t>(std::max(0.0, std::floor(sync_->tick())));
}

void InputClock::judge(const SlackReport& report) {
  slack_ = report.slack;
  // Of ticks that were predicted and sent together, the oldest must be in time.
  const std::uint32_t older = burst_[report.tick % burst_.size()];
  if (older <= report.tick) sync_->report(report.tick - older, report.slack - static_cast<std::int32_t>(older));
}

void InputClock::update(Moment now, std::uint32_t next) {
  if (!sync_) return;
  const double shown = sync_->tick();
  sync_->update(now);
  hiccup_ = sync_->tick() - shown >= kHiccupTicks;
  next_ = std::max(next, firstInput_);
}

void InputClock::chose(std::uint32_t tick) { burst_[tick % burst_.size()] = hiccup_ ? kNotJudged : tick - next_; }

}  // namespace platon
