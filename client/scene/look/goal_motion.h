#pragma once

namespace platon {

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
