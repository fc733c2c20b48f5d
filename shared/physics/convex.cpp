#include "platon/physics/convex.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "platon/exact/integer.h"

namespace platon {
namespace {

std::string atVertex(std::size_t index, const char* what) { return "vertex " + std::to_string(index + 1) + " " + what; }

bool inSameHalfPlane(Point a, Point b) {
  // The upper half plane is the angles in [0°, 180°), the lower one those in [180°, 360°).
  const auto lower = [](Point d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  return lower(a) == lower(b);
}

// A polygon that turns left at every vertex can still wind round more than once. With one winding, the directions of
// the edges change between the half planes exactly twice.
bool windsOnce(std::span<const Point> vertices) {
  int changes = 0;
  const std::size_t count = vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point edge = vertices[(i + 1) % count] - vertices[i];
    const Point next = vertices[(i + 2) % count] - vertices[(i + 1) % count];
    if (!inSameHalfPlane(edge, next)) ++changes;
  }
  return changes == 2;
}

bool lexicographic(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// One chain of Andrew's monotone chain algorithm, over sorted points.
template <class Iterator>
void appendChain(std::vector<Point>& hull, Iterator first, Iterator last) {
  const std::size_t base = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();
}

}  // namespace

std::optional<std::string> Convex::fault(std::span<const Point> vertices) {
  const std::size_t count = vertices.size();
  if (count < 3) return "a shape needs at least 3 vertices, not " + std::to_string(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isCoordinate(vertices[i].x) || !isCoordinate(vertices[i].y)) {
      return atVertex(i, "is out of range: coordinates must be below 2^29 in magnitude");
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Point here = vertices[(i + 1) % count];
    const std::int64_t turn = cross(here - vertices[i], vertices[(i + 2) % count] - here);
    if (turn == 0) return atVertex((i + 1) % count, "is collinear with its neighbours: remove it");
    if (turn < 0) return atVertex((i + 1) % count, "turns clockwise: a shape must be convex and counter-clockwise");
  }
  if (!windsOnce(vertices)) return "the edges wind around more than once";
  return std::nullopt;
}

Convex::Convex(std::vector<Point> vertices) : vertices_(std::move(vertices)) {
  if (const auto reason = fault(vertices_)) throw std::invalid_argument(*reason);
  bounds_ = {vertices_[0], vertices_[0]};
  std::int64_t sumX = 0;
  std::int64_t sumY = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Point here = vertices_[i];
    const Point normal = perpendicular(vertices_[(i + 1) % vertices_.size()] - here);
    edges_.push_back({normal, dot(normal, here)});
    bounds_.low = {std::min(bounds_.low.x, here.x), std::min(bounds_.low.y, here.y)};
    bounds_.high = {std::max(bounds_.high.x, here.x), std::max(bounds_.high.y, here.y)};
    sumX += here.x;
    sumY += here.y;
  }
  const auto count = static_cast<std::int64_t>(vertices_.size());
  centre_ = {static_cast<std::int32_t>(divideRounded(sumX, count)),
             static_cast<std::int32_t>(divideRounded(sumY, count))};
}

std::optional<Convex> Convex::turned(Angle angle) const {
  if (angle == Angle()) return *this;
  std::vector<Point> points;
  points.reserve(vertices_.size());
  const Rotation rotation = rotationOf(angle);
  for (const Point vertex : vertices_) points.push_back(rotate(vertex, rotation));
  auto hull = convexHull(std::move(points));
  if (fault(hull)) return std::nullopt;
  Convex result(std::move(hull));
  result.centre_ = rotate(centre_, rotation);  // a mean would jump when the hull loses a vertex
  return result;
}

std::vector<Point> convexHull(std::vector<Point> points) {
  if (points.empty()) return points;
  const std::vector<Point> given = points;
  std::sort(points.begin(), points.end(), lexicographic);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  appendChain(hull, points.begin(), points.end());
  appendChain(hull, points.rbegin(), points.rend());
  for (const Point first : given) {
    const auto found = std::find(hull.begin(), hull.end(), first);
    if (found == hull.end()) continue;
    std::rotate(hull.begin(), found, hull.end());
    break;
  }
  return hull;
}

}  // namespace platon
