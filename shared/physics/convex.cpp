#include "platon/physics/convex.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Vertices are counted from 1. Their number and the coordinates leave no doubt which one is meant.
std::string atVertex(std::span<const Point> vertices, std::size_t index, const std::string& what) {
  const Point at = vertices[index];
  return "vertex " + std::to_string(index + 1) + " of " + std::to_string(vertices.size()) + ", (" +
         std::to_string(at.x) + ", " + std::to_string(at.y) + "), " + what;
}

// What is wrong with a vertex at which the polygon does not turn.
std::string straightAt(std::span<const Point> vertices, std::size_t index) {
  const std::size_t count = vertices.size();
  for (const std::size_t neighbour : {(index + count - 1) % count, (index + 1) % count}) {
    if (vertices[index] == vertices[neighbour])
      return atVertex(vertices, index, "equals vertex " + std::to_string(neighbour + 1) + ": remove it");
  }
  return atVertex(vertices, index, "is collinear with its neighbours: remove it");
}

bool inSameHalfPlane(Point a, Point b) {
  // The upper half plane is the angles in [0°, 180°), the lower one those in [180°, 360°).
  const auto lower = [](Point d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  return lower(a) == lower(b);
}

// A polygon that turns left at every vertex can still wind round more than once. With one winding, the directions of
// the edges change between the half planes exactly twice.
bool windsOnce(std::span<const Point> vertices) {
  int changes = 0;
  Point last = vertices.back();
  Point edge = last - vertices[vertices.size() - 2];
  for (const Point vertex : vertices) {
    const Point next = vertex - last;
    if (!inSameHalfPlane(edge, next)) ++changes;
    edge = next;
    last = vertex;
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

// Writes the convex hull of the points, counter-clockwise, and sorts them. Fewer than three points if all are
// collinear.
void fillHull(std::vector<Point>& points, std::vector<Point>& hull) {
  std::sort(points.begin(), points.end(), lexicographic);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  hull.clear();
  if (points.size() < 3) {
    hull.assign(points.begin(), points.end());
    return;
  }
  appendChain(hull, points.begin(), points.end());
  appendChain(hull, points.rbegin(), points.rend());
}

// Rotates the order of the hull so that it starts with the first of its vertices among `given`. Returns whether there
// is one.
bool startAtFirst(std::vector<Point>& hull, std::span<const Point> given) {
  for (const Point first : given) {
    const auto found = std::find(hull.begin(), hull.end(), first);
    if (found == hull.end()) continue;
    std::rotate(hull.begin(), found, hull.end());
    return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> Convex::fault(std::span<const Point> vertices) {
  const std::size_t count = vertices.size();
  if (count < 3) return "a shape needs at least 3 vertices, not " + std::to_string(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isCoordinate(vertices[i].x) || !isCoordinate(vertices[i].y)) {
      return atVertex(vertices, i, "is out of range: coordinates must be below 2^29 in magnitude");
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t middle = i + 1 < count ? i + 1 : 0;
    const Point here = vertices[middle];
    const std::int64_t turn = cross(here - vertices[i], vertices[middle + 1 < count ? middle + 1 : 0] - here);
    if (turn == 0) return straightAt(vertices, middle);
    if (turn < 0) return atVertex(vertices, middle, "turns clockwise: a shape must be convex and counter-clockwise");
  }
  if (!windsOnce(vertices)) return "the edges wind around more than once";
  return std::nullopt;
}

Convex::Convex(std::vector<Point> vertices) : vertices_(std::move(vertices)) {
  if (const auto reason = fault(vertices_)) throw std::invalid_argument(*reason);
  deriveFromVertices();
}

void Convex::deriveFromVertices() {
  bounds_ = {vertices_[0], vertices_[0]};
  edges_.clear();
  std::int64_t sumX = 0;
  std::int64_t sumY = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Point here = vertices_[i];
    const Point normal = perpendicular(vertices_[i + 1 < vertices_.size() ? i + 1 : 0] - here);
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
  Convex result = *this;
  if (angle == Angle() || turnInto(result, angle)) return result;
  auto hull = convexHull(std::move(result.vertices_));
  if (fault(hull)) return std::nullopt;
  result = Convex(std::move(hull));
  result.centre_ = rotate(centre_, angle);  // a mean would jump when the hull loses a vertex
  return result;
}

// The rotated vertices are their own hull when they are strictly convex, which is usual.
bool Convex::turnInto(Convex& result, Angle angle) const {
  const Rotation rotation = rotationOf(angle);
  result.vertices_.resize(vertices_.size());
  std::transform(vertices_.begin(), vertices_.end(), result.vertices_.begin(),
                 [&](Point vertex) { return rotate(vertex, rotation); });
  if (fault(result.vertices_)) return false;
  result.deriveFromVertices();
  result.centre_ = rotate(centre_, rotation);
  return true;
}

void Convex::becomeHull(const Convex& a, const Convex& b, std::vector<Point>& work) {
  work.assign(a.vertices_.begin(), a.vertices_.end());
  work.insert(work.end(), b.vertices_.begin(), b.vertices_.end());
  fillHull(work, vertices_);
  if (!startAtFirst(vertices_, a.vertices_)) startAtFirst(vertices_, b.vertices_);
  deriveFromVertices();
}

std::vector<Point> convexHull(std::vector<Point> points) {
  const std::vector<Point> given = points;
  std::vector<Point> hull;
  fillHull(points, hull);
  startAtFirst(hull, given);
  return hull;
}

}  // namespace platon
