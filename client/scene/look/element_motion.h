#pragma once

#include <cstdint>
#include <vector>

namespace platon {

/// How doors, plates and `up` blocks move in the picture when their states change. The states themselves change at
/// once; it decides nothing.
class ElementMotion {
 public:
  static constexpr double kSeconds = 0.25;  ///< from one state to the other

  /// The states at `seconds`, as ElementStates::active. A time before the last one, a change without time, or
  /// another number of elements begins anew, with nothing in motion.
  void advance(const std::vector<std::uint8_t>& active, double seconds);
  /// Ends all motion.
  void settle();

  /// How active each element looks: 0 … 1, smooth in time.
  const std::vector<double>& shares() const { return shares_; }

 private:
  std::vector<std::uint8_t> active_;
  std::vector<double> progress_;  // linear in time
  std::vector<double> shares_;
  double seconds_ = 0;
};

}  // namespace platon
