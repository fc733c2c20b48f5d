#include "shared/physics/slide.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "platon/exact/integer.h"

namespace platon {
namespace {

bool xDominates(Point vector) { return std::abs(std::int64_t{vector.x}) >= std::abs(std::int64_t{vector.y}); }

// One coordinate of the projection: along * tangent / squaredLength, truncated. Bounds: |along| < 2^62,
// |tangent| < 2^30, squaredLength < 2^61.
std::int64_t projected(std::int64_t along, std::int32_t tangent, std::int64_t squaredLength) {
  return scaleTruncated(along, tangent, squaredLength);
}

// The smallest v with v * normal >= least; the largest when `normal` is negative.
std::int64_t outwards(std::int64_t least, std::int32_t normal) {
  return normal > 0 ? divideCeiling<std::int64_t>(least, normal) : -divideCeiling<std::int64_t>(least, -normal);
}

struct Extent {
  std::int64_t low, high;
};

Extent extentOf(Point point, Point tangent) { return {dot(point, tangent), dot(point, tangent)}; }

Extent joined(Extent a, Extent b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

// The extent along `tangent` of the vertices with the smallest dot(normal, vertex): one vertex, or the two of an edge.
Extent lowestExtent(const Convex& shape, Point normal, Point tangent) {
  Extent extent = extentOf(shape.vertices().front(), tangent);
  std::int64_t depth = dot(normal, shape.vertices().front());
  for (const Point vertex : shape.vertices()) {
    const std::int64_t at = dot(normal, vertex);
    if (at > depth) continue;
    extent = at < depth ? extentOf(vertex, tangent) : joined(extent, extentOf(vertex, tangent));
    depth = at;
  }
  return extent;
}

// Bits of the larger coordinate of a rotated normal.
constexpr int kNormalBits = 29;

// `value` / 2^bits rounded away from zero. |value| < 2^62.
std::int64_t shiftAwayFromZero(int bits, std::int64_t value) {
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  return value >= 0 ? (value + most) >> bits : -((most - value) >> bits);
}

// The multiple v of `tangent` with dot(v, tangent) = `along`, truncated; (0, 0) when `along` is negative. Bounds:
// |tangent| < 2^30, along < 2^62.
Point multipleOf(Point tangent, std::int64_t along) {
  const std::int64_t whole = squaredLength(tangent);
  const auto scaled = [&](std::int32_t coordinate) {
    const std::int64_t cut = scaleTruncated(std::max<std::int64_t>(along, 0), coordinate, whole);
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(cut, -kCoordinateLimit, kCoordinateLimit));
  };
  return {scaled(tangent.x), scaled(tangent.y)};
}

}  // namespace

Point slideAlong(Point displacement, Point normal, SlideLimits limits) {
  const Point tangent = perpendicular(normal);
  const std::int64_t along = dot(displacement, tangent);
  const std::int64_t length = squaredLength(tangent);
  const std::int64_t longest = std::int64_t{1} + (along > 0 ? limits.forward : limits.backward);
  if (xDominates(tangent)) {
    const std::int64_t x = std::clamp(projected(along, tangent.x, length), -longest, longest);
    if (x == 0) return {};
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(outwards(-x * normal.x, normal.y))};
  }
  const std::int64_t y = std::clamp(projected(along, tangent.y, length), -longest, longest);
  if (y == 0) return {};
  return {static_cast<std::int32_t>(outwards(-y * normal.y, normal.x)), static_cast<std::int32_t>(y)};
}

Fraction fractionCovered(Point moved, Point whole) {
  const bool x = xDominates(whole);
  const std::int64_t all = x ? whole.x : whole.y;
  const std::int64_t done = x ? moved.x : moved.y;
  return {std::clamp<std::int64_t>(all > 0 ? done : -done, 0, std::abs(all)), std::abs(all)};
}

Point displacementToEdgeEnd(const Convex& shape, Point position, const Segment& segment, Point normal, bool back) {
  const Point tangent = perpendicular(normal);
  Extent ends = extentOf(segment.a, tangent);
  if (dot(normal, segment.a) == dot(normal, segment.b)) {
    ends = joined(ends, extentOf(segment.b, tangent));
  } else if (dot(normal, segment.b) > dot(normal, segment.a)) {
    ends = extentOf(segment.b, tangent);
  }
  const Extent touching = lowestExtent(shape, normal, tangent);
  const std::int64_t here = dot(position, tangent);
  return back ? multipleOf(-tangent, here - (ends.low - touching.high))
              : multipleOf(tangent, ends.high - touching.low - here);
}

// Compares with twice the longest displacement times the length of the tangent. Twice a displacement whose coordinates
// are `longest` is below 3 * longest; 16 subunits allow for rounding; the length is at most the sum of the coordinates.
bool extendsBeyond(std::int32_t longest, const Box& shape, Point position, const Segment& segment, Point tangent) {
  if (longest >= kCoordinateLimit / 2) return false;
  const Point foremost{tangent.x > 0 ? shape.high.x : shape.low.x, tangent.y > 0 ? shape.high.y : shape.low.y};
  const std::int64_t left =
      std::max(dot(segment.a, tangent), dot(segment.b, tangent)) - dot(position + foremost, tangent);
  return left >= (std::int64_t{3} * longest + 16) * (std::int64_t{std::abs(tangent.x)} + std::abs(tangent.y));
}

Point turnedNormal(Point normal, Rotation rotation) {
  const WideVector turned = rotateWide(normal, rotation);
  const auto longer = static_cast<std::uint64_t>(std::max(std::abs(turned.x), std::abs(turned.y)));
  int bits = std::max(static_cast<int>(std::bit_width(longer)) - kNormalBits, 0);
  if (shiftAwayFromZero(bits, static_cast<std::int64_t>(longer)) == std::int64_t{1} << kNormalBits) ++bits;
  return {static_cast<std::int32_t>(shiftAwayFromZero(bits, turned.x)),
          static_cast<std::int32_t>(shiftAwayFromZero(bits, turned.y))};
}

Point dominantStep(Point vector) {
  if (xDominates(vector)) return {vector.x > 0 ? 1 : -1, 0};
  return {0, vector.y > 0 ? 1 : -1};
}

}  // namespace platon
