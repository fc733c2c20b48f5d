#include "tests/fuzz/fuzz_scene.h"

#include <algorithm>
#include <cmath>

#include "platon/game/player.h"
#include "platon/game/stage.h"
#include "platon/physics/map_part.h"
#include "shared/game/face_area.h"
#include "tests/exactness/step_check/conversions.h"

namespace platon::fuzz {
namespace {

using oracle::Polygon;
using oracle::Vec;
using step_check::toPoint;
using step_check::toPoints;
using step_check::toPolygon;

constexpr std::size_t kMaxLines = 24;

Polygon hullFrom(ByteSource& bytes, std::int64_t radius) {
  std::vector<Vec> points(bytes.below(10) + 3);
  for (Vec& point : points) point = bytes.vector(radius);
  return oracle::convexHull(std::move(points));
}

// Rotation rounds each vertex by less than one subunit. A vertex more than three subunits from the line through its
// neighbours therefore stays convex.
bool staysConvex(const Polygon& polygon, std::size_t vertex) {
  const Vec before = polygon[vertex];
  const Vec here = polygon[(vertex + 1) % polygon.size()];
  const Vec after = polygon[(vertex + 2) % polygon.size()];
  const Vec base = after - before;
  const auto height = static_cast<long double>(oracle::cross(base, before - here)) /
                      std::hypot(static_cast<long double>(base.x), static_cast<long double>(base.y));
  return height > 3;
}

bool staysConvexWhenRotated(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!staysConvex(polygon, i)) return false;
  }
  return true;
}

// Random segments, chains whose joints are slightly off, parallels to edges of the shape, and points.
std::vector<oracle::Segment> linesFrom(ByteSource& bytes, const Polygon& shape, std::int64_t radius) {
  std::vector<oracle::Segment> lines(bytes.below(kMaxLines + 1));
  oracle::Segment last;
  for (oracle::Segment& line : lines) {
    const std::size_t edge = bytes.below(shape.size());
    const Vec along = shape[(edge + 1) % shape.size()] - shape[edge];
    const Vec a = bytes.flag() ? last.b + bytes.vector(2) : bytes.vector(radius);
    switch (bytes.below(5)) {
      case 0:
        line = {a, a + (last.b - last.a) + bytes.vector(1)};
        break;
      case 1:
        line = {a, a};
        break;
      case 2:
        line = {a, a + bytes.between(-2, 2) * along};
        break;
      case 3:
        line = {a, last.a};
        break;
      default:
        line = {a, bytes.vector(radius)};
    }
    last = line;
  }
  return lines;
}

bool inRange(const oracle::Segment& line, std::int64_t limit) {
  const oracle::Box box = boxOf(line);
  return box.low.x > -limit && box.low.y > -limit && box.high.x < limit && box.high.y < limit;
}

std::optional<FuzzScene> makePlane(ByteSource& bytes) {
  const std::int64_t scale = std::int64_t{1} << bytes.between(2, 24);
  const Polygon shape = hullFrom(bytes, scale);
  if (shape.size() < 3) return std::nullopt;
  World stage;
  MapPart part(stage, 0);
  std::size_t count = 0;
  for (const oracle::Segment& line : linesFrom(bytes, shape, 4 * scale)) {
    if (!inRange(line, oracle::kCoordinateLimit)) continue;
    part.line(toPoint(line.a), toPoint(line.b));
    ++count;
  }
  part.initialize();
  return FuzzScene{
      std::move(stage), std::nullopt, 0, {count}, Convex(toPoints(shape)), scale, staysConvexWhenRotated(shape)};
}

// Moves the mean of the vertices, which determines the home part, to the origin.
Polygon centred(Polygon polygon) {
  Vec sum;
  for (const Vec vertex : polygon) sum = sum + vertex;
  const auto count = static_cast<std::int64_t>(polygon.size());
  for (Vec& vertex : polygon) vertex = vertex - Vec{sum.x / count, sum.y / count};
  return polygon;
}

// A shape that stays convex when rotated, as every shape on a solid is.
std::optional<Convex> solidShape(ByteSource& bytes, std::int64_t scale) {
  if (bytes.flag()) return playerShape();
  const Polygon hull = hullFrom(bytes, scale);
  if (hull.size() < 3 || !staysConvexWhenRotated(hull)) return std::nullopt;
  return Convex(toPoints(centred(hull)));
}

FinePoint fine(Vec v) { return {v.x * FinePoint::kPerSubunit, v.y * FinePoint::kPerSubunit}; }

std::optional<FuzzScene> makeSolid(ByteSource& bytes, SolidKind kind) {
  const auto faceSize = static_cast<std::int32_t>(bytes.between(kMinFaceSize, kMinFaceSize + 255));
  const std::int64_t scale = bytes.between(1, 64) * kSubunitsPerUnit;
  const auto shape = solidShape(bytes, scale);
  if (!shape) return std::nullopt;
  const FaceArea area(facePolygon(kind, faceSize));
  std::vector<std::vector<Segment>> lines(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
  const std::int64_t radius = std::int64_t{faceSize} * kSubunitsPerUnit / 2;
  for (const oracle::Segment& line : linesFrom(bytes, toPolygon(shape->vertices()), radius)) {
    auto& face = lines[bytes.below(lines.size())];
    if (const auto clipped = area.clip(fine(line.a), fine(line.b))) face.push_back(*clipped);
  }
  std::vector<std::size_t> counts;
  for (const auto& face : lines) counts.push_back(face.size());
  return FuzzScene{buildStage(kind, faceSize, lines), kind, faceSize, std::move(counts), *shape, scale, true};
}

}  // namespace

std::optional<FuzzScene> makeFuzzScene(ByteSource& bytes) {
  const std::size_t kind = bytes.below(2 * kSolidKinds);
  if (kind < kSolidKinds) return makePlane(bytes);
  return makeSolid(bytes, static_cast<SolidKind>(kind - kSolidKinds));
}

}  // namespace platon::fuzz
