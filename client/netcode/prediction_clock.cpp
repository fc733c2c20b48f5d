#include "client/netcode/prediction_clock.h"

#include <algorithm>
#include <cmath>

#include "protocol/limits.h"

namespace platon {

namespace {

// A pause between two updates, 0.25 s, after which the inputs are late because of this program, not of the connection.
constexpr std::uint32_t kStallTicks = 15;
constexpr std::uint32_t kIgnored = UINT32_MAX;  // batch offset of inputs chosen after a stall

std::uint32_t toTick(double tick) {
  return static_cast<std::uint32_t>(std::clamp(std::floor(tick), 0.0, double{UINT32_MAX}));
}

}  // namespace

void PredictionClock::receive(const ConfirmedTicks& message, Time now) {
  const double newest = double{1} * message.from + message.count;
  // A message of maximum length is part of a backlog and does not show the server's current tick.
  if (message.count < kMaxTicksPerMessage) startOrAdvance(newest + lead_, now);
  if (clock_ && message.link && message.link->slack) addReport(*message.link->slack);
  if (clock_ && reports_ > 0) lead_ = clock_->tick() - newest;
}

// The first message may have been delayed, so until the server reports slack the least delayed message sets the clock.
void PredictionClock::startOrAdvance(double tick, Time now) {
  if (clock_) {
    if (reports_ == 0) clock_->setTarget(std::max(clock_->target(), clock_->lead() + tick - clock_->tick()));
    return;
  }
  clock_.emplace(tick, now, kMaxSlew, kJumpTicks);
  recordLead(tick - 1, tick);
  firstInput_ = toTick(tick);
}

void PredictionClock::update(Time now, std::uint32_t next) {
  if (!clock_) return;
  const double before = clock_->tick();
  const bool jumped = clock_->update(now, settling() && clock_->error() < -kJumpTicksWhileSettling);
  // The inputs for ticks that a jump skips are sent late in any case, so they give no samples.
  recordLead(jumped ? std::max(before, clock_->tick() - 1) : before, clock_->tick());
  stalled_ = clock_->tick() - before >= kStallTicks;
  batchStart_ = std::max(next, firstInput_);
}

void PredictionClock::recordLead(double from, double to) {
  const auto first = static_cast<std::int64_t>(std::max(std::floor(from) + 1, std::floor(to) + 1 - double{kHistory}));
  const auto last = static_cast<std::int64_t>(std::floor(to));
  for (std::int64_t tick = std::max<std::int64_t>(first, 0); tick <= last; ++tick) {
    pastLeads_[static_cast<std::size_t>(tick) % kHistory] = {static_cast<std::uint32_t>(tick), true, clock_->lead()};
  }
}

void PredictionClock::inputChosen(std::uint32_t tick) {
  batchOffsets_[tick % kBatchWindow] = stalled_ ? kIgnored : tick - batchStart_;
}

void PredictionClock::addReport(const SlackReport& report) {
  slack_ = report.slack;
  // The oldest input of a batch that was sent together must arrive in time.
  const std::uint32_t offset = batchOffsets_[report.tick % kBatchWindow];
  if (offset <= report.tick) addSample(report.tick - offset, report.slack - static_cast<std::int32_t>(offset));
}

void PredictionClock::addSample(std::uint32_t tick, std::int32_t slack) {
  const PastLead& past = pastLeads_[tick % kHistory];
  if (!past.valid || past.tick != tick) return;
  samples_.add(past.lead - slack);
  ++reports_;
  const double target = samples_.quantile(0.99) + kSpareTicks;
  clock_->setTarget(settling() ? std::max(target, clock_->lead()) : target);
}

double PredictionClock::jitterTicks() const {
  return samples_.empty() ? 0.0 : samples_.quantile(0.99) - samples_.quantile(0.5);
}

}  // namespace platon
