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

/// How the goal answers a finish: it opens, and light bursts from it.
class GoalMotion {
 public:
  static constexpr double kOpening = 0.5;  ///< seconds until it is open
  static constexpr double kBurst = 1.4;    ///< seconds that the burst lasts

  /// Whether the player has arrived at `seconds`. A time before the last one begins anew.
  void advance(bool arrived, double seconds);

  /// Ends the motion: the goal is open or closed, and nothing bursts from it.
  void settle();

  /// 0: closed … 1: open.
  double opened() const { return opened_; }
  /// How far the burst is, 0 … 1. At both ends, nothing is seen of it.
  double burst() const { return burst_; }

 private:
  bool arrived_ = false;
  double seconds_ = 0;
  double since_ = 0;  // when the player arrived
  double opened_ = 0;
  double burst_ = 1;
};

}  // namespace platon
