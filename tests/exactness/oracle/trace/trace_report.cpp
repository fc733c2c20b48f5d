#include "tests/exactness/oracle/trace/trace_report.h"

#include <algorithm>
#include <ostream>

namespace platon::oracle {
namespace {

constexpr std::size_t kMessagesKept = 20;

}  // namespace

void TraceReport::violate(const std::string& law, const std::string& what) {
  ++violations_;
  brokenLaws_.insert(law);
  if (messages_.size() >= kMessagesKept) return;
  std::string where = "header";
  if (tick_ >= 0) where = "tick " + std::to_string(tick_);
  if (tick_ >= 0 && player_ >= 0) where += " player " + std::to_string(player_) + " leg " + std::to_string(leg_);
  messages_.push_back(where + ": " + law + ": " + what);
}

void TraceReport::noteLegs(std::size_t count) {
  legs += static_cast<std::int64_t>(count);
  mostLegs_ = std::max(mostLegs_, count);
}

void TraceReport::noteInstances(std::size_t count) { mostInstances_ = std::max(mostInstances_, count); }

void TraceReport::notePlacementError(long double error) { worstPlacement_ = std::max(worstPlacement_, error); }

std::ostream& operator<<(std::ostream& stream, const TraceReport& report) {
  stream << report.ticks << " ticks, " << report.playerTicks << " player ticks, " << report.legs << " legs (at most "
         << report.mostLegs_ << " a tick), at most " << report.mostInstances_ << " instances, " << report.crossings
         << " crossings, " << report.facesVisited.size() << " faces visited, worst placement "
         << static_cast<double>(report.worstPlacement_) << " subunits, " << report.violations_ << " violations";
  for (const std::string& message : report.messages_) stream << "\n  " << message;
  return stream;
}

}  // namespace platon::oracle
