#include "tests/exactness/oracle/trace/trace_report.h"

#include <algorithm>
#include <ostream>

namespace platon::oracle {
namespace {

constexpr std::size_t kMaxMessages = 20;

}  // namespace

void TraceReport::violate(const std::string& rule, const std::string& what) {
  ++violations_;
  violatedRules_.insert(rule);
  if (messages_.size() >= kMaxMessages) return;
  std::string where = "header";
  if (tick_ >= 0) where = "tick " + std::to_string(tick_);
  if (tick_ >= 0 && player_ >= 0) where += " player " + std::to_string(player_) + " leg " + std::to_string(leg_);
  messages_.push_back(where + ": " + rule + ": " + what);
}

void TraceReport::noteLegs(std::size_t count) {
  legs += static_cast<std::int64_t>(count);
  maxLegs_ = std::max(maxLegs_, count);
}

void TraceReport::noteInstances(std::size_t count) { maxInstances_ = std::max(maxInstances_, count); }

void TraceReport::notePlacementError(long double error) { maxPlacementError_ = std::max(maxPlacementError_, error); }

std::ostream& operator<<(std::ostream& stream, const TraceReport& report) {
  stream << report.ticks << " ticks, " << report.playerTicks << " player ticks, " << report.legs << " legs (at most "
         << report.maxLegs_ << " a tick), at most " << report.maxInstances_ << " instances, " << report.crossings
         << " crossings, " << report.facesVisited.size() << " faces visited, " << report.elementsPassed.size()
         << " elements passed, " << report.returns << " returns, largest placement error "
         << static_cast<double>(report.maxPlacementError_) << " subunits, " << report.violations_ << " violations";
  for (const std::string& message : report.messages_) stream << "\n  " << message;
  return stream;
}

}  // namespace platon::oracle
