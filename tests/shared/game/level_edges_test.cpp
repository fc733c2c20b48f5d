// Lines written on both faces of an edge continue over it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "shared/game/face_area.h"

namespace platon::level_edges_test {
namespace {

struct Place {
  long double x;
  long double y;
};

// Corners of the regular polygon with this edge length, not rounded.
std::vector<Place> regularPolygon(int count, long double edge) {
  const long double step = 2 * std::acos(-1.0L) / count;
  std::vector<Place> corners;
  for (int i = 0; i < count; ++i) {
    const long double angle = (static_cast<long double>(i) - 0.5L) * step - std::acos(-1.0L) / 2;
    const long double radius = edge / (2 * std::sin(step / 2));
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}

// The point at `along` edge lengths from `corner` towards `next`, and `beyond` edge lengths to the right of the edge.
Place besideEdge(const Place& corner, const Place& next, long double along, long double beyond) {
  const long double dx = next.x - corner.x;
  const long double dy = next.y - corner.y;
  return {corner.x + along * dx + beyond * dy, corner.y + along * dy - beyond * dx};
}

// The point as a level text gives it: with four decimals.
FinePoint written(const Place& place) {
  const auto decimal = [](long double units) { return std::llround(units * 10000) * FinePoint::kPerTenThousandth; };
  return {decimal(place.x), decimal(place.y)};
}

// The end of the line that is nearer to the edge from `corner`, in subunits along and beyond the edge.
Place endAtEdge(const std::vector<Point>& polygon, std::size_t corner, const Segment& line) {
  const Point from = polygon[corner];
  const Point edge = polygon[(corner + 1) % polygon.size()] - from;
  const long double length = std::sqrt(static_cast<long double>(squaredLength(edge)));
  const auto relative = [&](Point end) {
    return Place{static_cast<long double>(dot(edge, end - from)) / length,
                 static_cast<long double>(-cross(edge, end - from)) / length};
  };
  const Place a = relative(line.a);
  const Place b = relative(line.b);
  return std::abs(a.y) < std::abs(b.y) ? a : b;
}

// Writes a line that crosses an edge at an angle of at least 30 degrees on both faces, and returns the distance between
// its two clipped ends when the faces are unfolded, in subunits.
long double gapOverAnEdge(SolidKind kind, std::int32_t size, std::mt19937_64& random) {
  const int edges = PlatonicSolid::of(kind).edgesPerFace();
  const auto true_ = regularPolygon(edges, size);
  const auto polygon = facePolygon(kind, size);
  const FaceArea area(polygon);
  const auto chance = [&] { return static_cast<long double>(random() % 1000001) / 1000000; };
  const auto here = static_cast<std::size_t>(random() % static_cast<unsigned>(edges));
  const auto there = static_cast<std::size_t>(random() % static_cast<unsigned>(edges));
  const auto after = [&](std::size_t corner) { return (corner + 1) % polygon.size(); };
  const long double crossing = 0.25L + chance() / 2;
  const long double slope = (2 * chance() - 1) * std::sqrt(3.0L);
  const auto cutOn = [&](std::size_t corner, bool mirrored) {
    const auto at = [&](long double beyond) {
      const long double along = crossing + slope * beyond;
      return mirrored ? besideEdge(true_[corner], true_[after(corner)], 1 - along, -beyond)
                      : besideEdge(true_[corner], true_[after(corner)], along, beyond);
    };
    const auto line = area.clip(written(at(-0.1L)), written(at(0.1L)));
    return endAtEdge(polygon, corner, line.value());
  };
  const Place one = cutOn(here, false);
  const Place other = cutOn(there, true);
  const long double length = static_cast<long double>(size) * kSubunitsPerUnit;
  return std::hypot(one.x - (length - other.x), one.y + other.y);
}

TEST(LevelEdgesTest, LinesAcrossAnEdgeMeetWithin3Subunits) {
  constexpr std::uint64_t seed = 99;
  std::mt19937_64 random(seed);
  long double largest = 0;
  long double sum = 0;
  constexpr int tries = 60000;
  for (int i = 0; i < tries; ++i) {
    const auto kind = static_cast<SolidKind>(i % kSolidKinds);
    const auto size = static_cast<std::int32_t>(i % 7 == 0 ? kMaxFaceSize : 200 + i % 1500);
    const long double gap = gapOverAnEdge(kind, size, random);
    ASSERT_LE(gap, 3.0L) << nameOf(kind) << " " << size << ", seed " << seed;
    largest = std::max(largest, gap);
    sum += gap;
  }
  RecordProperty("maxThousandths", static_cast<int>(largest * 1000));
  EXPECT_LE(sum / tries, 1.0L);
}

}  // namespace
}  // namespace platon::level_edges_test
