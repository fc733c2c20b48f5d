#include "client/netcode/report_schedule.h"

#include <algorithm>
#include <chrono>

namespace platon {

namespace {

constexpr std::uint32_t kTicksBetweenReports = 4;
constexpr std::uint32_t kRepeats = 2;  // of a change, each a tick after the one before
constexpr Moment kIdleReport = std::chrono::milliseconds(80);

}  // namespace

void ReportSchedule::chose(Input input) {
  chosen_ = true;
  changed_ = changed_ || input != last_;
  last_ = input;
}

bool ReportSchedule::due(Moment now, std::uint32_t ticks) const {
  if (!toldAt_ || now - *toldAt_ >= kIdleReport || hurried_) return true;
  if (!chosen_ || ticks <= toldTicks_) return false;
  return repeats_ > 0 || ticks - toldTicks_ >= kTicksBetweenReports || changed_;
}

void ReportSchedule::told(Moment now, std::uint32_t ticks) {
  repeats_ = changed_ ? kRepeats : repeats_ - std::min(repeats_, 1u);
  chosen_ = changed_ = hurried_ = false;
  toldAt_ = now;
  toldTicks_ = ticks;
}

}  // namespace platon
