#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/path_obstacle.h"

namespace platon::reference {

/// A box around a straight way of the body, larger than the rounding errors of double.
struct Reach {
  double lowX, lowY, highX, highY;

  /// From a place, with a displacement.
  Reach(const Place& from, double x, double y);
  explicit Reach(const oracle::Box& box);

  bool touches(const Reach& other) const {
    return lowX <= other.highX && other.lowX <= highX && lowY <= other.highY && other.lowY <= highY;
  }
};

/// The obstacles of a scene, sorted along the velocity, so that those near a place are found quickly.
class Course {
 public:
  explicit Course(const ExactScene& scene);

  const PathObstacle& operator[](std::size_t obstacle) const { return obstacles_[obstacle]; }
  /// Ascending indices of all obstacles that touch `reach`.
  std::vector<std::size_t> near(const Reach& reach) const;

 private:
  /// The interval that a box covers along the velocity.
  std::pair<double, double> along(const Reach& reach) const;

  double velocityX_;
  double velocityY_;
  std::vector<PathObstacle> obstacles_;
  std::vector<Reach> boxes_;
  std::vector<std::pair<double, std::size_t>> order_;  // where an obstacle begins, and its index
  double longest_ = 0;                                 // largest extent of an obstacle
};

/// The nearest double; also right where a number alone is beyond the range of double.
double quotient(const mpz_class& numerator, const mpz_class& denominator);

}  // namespace platon::reference
