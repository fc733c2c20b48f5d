#pragma once

#include <cstdint>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

namespace platon::oracle {

/// Counts of a trace, and the violations found in it.
class TraceReport {
 public:
  std::int64_t ticks = 0;
  std::int64_t playerTicks = 0;
  std::int64_t legs = 0;
  std::int64_t crossings = 0;  ///< changes of the home face
  std::set<std::int64_t> facesVisited;
  std::set<std::int64_t> elementsPassed;
  std::int64_t returns = 0;  ///< players that were moved back to the start or to a checkpoint

  /// Sets the place of the following violations.
  void setTick(std::int64_t tick) { tick_ = tick; }
  void setPlayer(std::int64_t player) { player_ = player; }
  void setLeg(std::size_t leg) { leg_ = leg; }

  /// Adds a violation. `rule` is the short name of the rule, `what` a sentence about the violation.
  void violate(const std::string& rule, const std::string& what);

  void noteLegs(std::size_t count);
  void noteInstances(std::size_t count);
  /// Distance, in subunits, of an instance from its image under the isometry.
  void notePlacementError(long double error);

  bool clean() const { return violations_ == 0; }
  /// The first 20 violations, one line each.
  const std::vector<std::string>& messages() const { return messages_; }
  /// Names of the violated rules.
  const std::set<std::string>& violatedRules() const { return violatedRules_; }

  friend std::ostream& operator<<(std::ostream& stream, const TraceReport& report);

 private:
  std::int64_t tick_ = -1;
  std::int64_t player_ = -1;
  std::size_t leg_ = 0;
  std::size_t maxLegs_ = 0;
  std::size_t maxInstances_ = 0;
  long double maxPlacementError_ = 0;
  std::int64_t violations_ = 0;
  std::vector<std::string> messages_;
  std::set<std::string> violatedRules_;
};

}  // namespace platon::oracle
