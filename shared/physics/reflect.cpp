#include "platon/physics/reflect.h"

#include <stdexcept>
#include <string>

#include "platon/exact/integer.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/segment.h"

namespace platon {
namespace {

std::string named(Point point) { return "(" + std::to_string(point.x) + ", " + std::to_string(point.y) + ")"; }

bool isNormal(Point normal) {
  const auto isInRange = [](std::int32_t value) { return value > -kNormalLimit && value < kNormalLimit; };
  return normal != Point() && isInRange(normal.x) && isInRange(normal.y);
}

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("reflect: " + what);
}

}  // namespace

// Bounds: |v·N| < 2^59, its product with d + n <= 2^32 is < 2^91, and with a coordinate of N < 2^121; d * N·N < 2^92,
// its product with a coordinate of v < 2^120.
Point reflect(Point velocity, Point normal, std::int32_t numerator, std::int32_t denominator) {
  require(isVelocity(velocity),
          "the velocity " + named(velocity) + " is out of range: its coordinates must be below 2^28 in magnitude");
  require(isNormal(normal), "the normal " + named(normal) +
                                " is out of range: it must not be (0, 0), and its coordinates must be below 2^30 in "
                                "magnitude");
  require(denominator > 0 && numerator >= 0 && numerator <= denominator,
          "the restitution " + std::to_string(numerator) + "/" + std::to_string(denominator) +
              " is out of range: it must be from 0 to 1, with a denominator above 0");
  const std::int64_t against = dot(velocity, normal);
  if (against >= 0) return velocity;
  const int128 scaled = (int128{denominator} + numerator) * against;
  const int128 divisor = int128{denominator} * squaredLength(normal);
  const auto after = [&](std::int32_t before, std::int32_t along) {
    return static_cast<std::int32_t>(divideRounded(before * divisor - scaled * along, divisor));
  };
  return {after(velocity.x, normal.x), after(velocity.y, normal.y)};
}

}  // namespace platon
