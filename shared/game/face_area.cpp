#include "shared/game/face_area.h"

#include <algorithm>

#include "shared/exact/square_root.h"

namespace platon {
namespace {

// Position of a point on a line: 0 at its first end, 1 at its last. numerator / denominator is in [0, 1].
struct Parameter {
  int128 numerator;
  int128 denominator;

  friend bool operator<(Parameter a, Parameter b) { return a.numerator * b.denominator < b.numerator * a.denominator; }
};

std::int32_t roundFine(int128 value, int128 denominator) {
  return static_cast<std::int32_t>(divideRounded(value, denominator * FinePoint::kPerSubunit));
}

Point roundFine(FinePoint point) { return {roundFine(point.x, 1), roundFine(point.y, 1)}; }

Point pointAt(FinePoint a, FinePoint b, Parameter at) {
  const auto along = [&](std::int64_t from, std::int64_t to) {
    return roundFine(from * at.denominator + (to - from) * at.numerator, at.denominator);
  };
  return {along(a.x, b.x), along(a.y, b.y)};
}

// Below 2^64: a normal is the difference of two corners, and a coordinate is at most 2^17 units, 625 * 2^27 fine.
int128 dotFine(Point normal, FinePoint point) { return int128{normal.x} * point.x + int128{normal.y} * point.y; }

}  // namespace

struct FaceArea::Range {
  Parameter first{0, 1};
  Parameter last{1, 1};
};

FaceArea::FaceArea(std::span<const Point> polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point outward = -perpendicular(polygon[(i + 1) % polygon.size()] - polygon[i]);
    sides_.push_back(
        {outward, dot(outward, polygon[i]), static_cast<std::int64_t>(squareRootFloor(squaredLength(outward)))});
  }
}

bool FaceArea::contains(Point point) const {
  return std::all_of(sides_.begin(), sides_.end(),
                     [&](const Side& side) { return dot(side.outward, point) <= side.support; });
}

bool FaceArea::containsWithinSubunit(Point point) const {
  return std::all_of(sides_.begin(), sides_.end(),
                     [&](const Side& side) { return dot(side.outward, point) <= side.support + side.subunit; });
}

// Clips a–b at every side (Cyrus–Beck); `grown` moves the sides one subunit outwards. The numerators compared are below
// 10^19 and the denominators below 1.6 * 10^19, so that their products stay below 2^127.
std::optional<FaceArea::Range> FaceArea::rangeInside(FinePoint a, FinePoint b, bool grown) const {
  Range range;
  for (const Side& side : sides_) {
    const int128 bound = int128{side.support + (grown ? side.subunit : 0)} * FinePoint::kPerSubunit;
    const int128 beyondA = dotFine(side.outward, a) - bound;
    const int128 beyondB = dotFine(side.outward, b) - bound;
    if (beyondA > 0 && beyondB > 0) return std::nullopt;
    if (beyondA > 0) range.first = std::max(range.first, {beyondA, beyondA - beyondB});
    if (beyondB > 0) range.last = std::min(range.last, {-beyondA, beyondB - beyondA});
  }
  if (range.last < range.first) return std::nullopt;
  return range;
}

// The lattice point nearest to `point` that is at most one subunit outside. Differs from `point` only beside a slanted
// edge; such a point always exists within 2 subunits.
Point FaceArea::nearestInside(Point point) const {
  if (containsWithinSubunit(point)) return point;
  constexpr std::int32_t window = 2;
  std::optional<Point> best;
  for (std::int32_t dy = -window; dy <= window; ++dy) {
    for (std::int32_t dx = -window; dx <= window; ++dx) {
      const Point step(dx, dy);
      if (!containsWithinSubunit(point + step)) continue;
      if (!best || squaredLength(step) < squaredLength(*best)) best = step;
    }
  }
  return best ? point + *best : point;
}

std::optional<Segment> FaceArea::clip(FinePoint a, FinePoint b) const {
  const auto range = [&]() -> std::optional<Range> {
    if (const auto inside = rangeInside(a, b, false)) return inside;
    return rangeInside(a, b, true);
  }();
  if (!range) return std::nullopt;
  const Point first = roundFine(a);
  const Point last = roundFine(b);
  return Segment{containsWithinSubunit(first) ? first : nearestInside(pointAt(a, b, range->first)),
                 containsWithinSubunit(last) ? last : nearestInside(pointAt(a, b, range->last))};
}

}  // namespace platon
