#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "tests/sim/seeded_random.h"

namespace platon::hard_cases {

inline constexpr double kPi = std::numbers::pi;

/// The lattice point nearest to the end of a vector of this length and angle.
inline Point polar(double length, double angle) {
  return Point(static_cast<std::int32_t>(std::lround(length * std::cos(angle))),
               static_cast<std::int32_t>(std::lround(length * std::sin(angle))));
}

/// The random numbers of one scene.
class Dice {
 public:
  Dice(std::uint64_t family, std::uint64_t scene) : random_(family * 1'000'003 + scene) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_.below(1 << 30)) / (1 << 30);
  }
  std::int32_t below(std::int32_t limit) {
    return static_cast<std::int32_t>(random_.below(static_cast<std::uint64_t>(limit)));
  }
  Point vector(std::int32_t reach) { return random_.vector(reach); }
  /// A regular polygon of 3 to 10 corners, rotated and rounded.
  Convex polygon(double radius) {
    const int corners = 3 + below(8);
    const double first = between(0, 2 * kPi);
    std::vector<Point> vertices;
    for (int i = 0; i < corners; ++i) vertices.push_back(polar(radius, first + 2 * kPi * i / corners));
    return Convex(vertices);
  }

 private:
  sim::SeededRandom random_;
};

}  // namespace platon::hard_cases
