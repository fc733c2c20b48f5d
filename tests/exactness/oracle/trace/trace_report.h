#pragma once

#include <cstdint>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

namespace platon::oracle {

/// What was counted in a trace, and every way in which it breaks its promises.
class TraceReport {
 public:
  std::int64_t ticks = 0;
  std::int64_t playerTicks = 0;
  std::int64_t legs = 0;       ///< moves from one leg entry to the next
  std::int64_t crossings = 0;  ///< changes of the home face
  std::set<std::int64_t> facesVisited;

  /// Says where the following violations are.
  void atTick(std::int64_t tick) { tick_ = tick; }
  void atPlayer(std::int64_t player) { player_ = player; }
  void atLeg(std::size_t leg) { leg_ = leg; }

  /// `law` is what was promised, a short name that violations are counted by; `what` is how it is broken.
  void violate(const std::string& law, const std::string& what);

  void noteLegs(std::size_t count);
  void noteInstances(std::size_t count);
  /// Distance in subunits of an instance from where the isometry puts it.
  void notePlacementError(long double error);

  bool clean() const { return violations_ == 0; }
  std::int64_t violations() const { return violations_; }
  /// The first violations, one line each.
  const std::vector<std::string>& messages() const { return messages_; }
  /// The laws that were broken.
  const std::set<std::string>& brokenLaws() const { return brokenLaws_; }

  friend std::ostream& operator<<(std::ostream& stream, const TraceReport& report);

 private:
  std::int64_t tick_ = -1;
  std::int64_t player_ = -1;
  std::size_t leg_ = 0;
  std::size_t mostLegs_ = 0;
  std::size_t mostInstances_ = 0;
  long double worstPlacement_ = 0;
  std::int64_t violations_ = 0;
  std::vector<std::string> messages_;
  std::set<std::string> brokenLaws_;
};

}  // namespace platon::oracle
