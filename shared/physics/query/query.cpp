#include "platon/physics/query.h"

#include <algorithm>

#include "platon/exact/integer.h"
#include "shared/physics/query/grid_walk.h"
#include "shared/physics/query/query_checks.h"

namespace platon {
namespace {

// Intersects the ray with a segment that is parallel to it, or one of which is a point. `a` and `b` are the ends of the
// segment, relative to the start of the ray.
std::optional<Fraction> parallelTime(Point a, Point b, Point displacement) {
  if (displacement == Point()) {
    if (cross(a, b) != 0 || dot(a, b) > 0) return std::nullopt;
    return Fraction{0, 1};
  }
  if (cross(a, displacement) != 0) return std::nullopt;
  const auto [near, far] = std::minmax({dot(a, displacement), dot(b, displacement)});
  const std::int64_t length = squaredLength(displacement);
  if (far < 0 || near > length) return std::nullopt;
  return Fraction{std::max<std::int64_t>(near, 0), length};
}

// The time at which the ray meets the line of a segment that is not parallel to it, if the common point is on both.
// Bounds: coordinates < 2^30, products < 2^61.
std::optional<Fraction> crossingTime(Point a, Point along, Point displacement, std::int64_t determinant) {
  const std::int64_t sign = determinant < 0 ? -1 : 1;
  const std::int64_t onRay = sign * cross(a, along);
  const std::int64_t onSegment = sign * cross(a, displacement);
  const std::int64_t whole = sign * determinant;
  if (onRay < 0 || onRay > whole || onSegment < 0 || onSegment > whole) return std::nullopt;
  return Fraction{onRay, whole};
}

// Meets a segment with a ray.
struct RayMeeting {
  Point from;
  Point displacement;
  bool onlyLeaves = false;  // meets only those warps over which it leaves the part, which is on their left

  using Found = RayHit;
  static Fraction timeOf(const RayHit& hit) { return hit.time; }
  static std::uint32_t indexOf(const RayHit& hit) { return hit.segment.index; }
  std::optional<RayHit> operator()(const SegmentRef& segment) const {
    const Point a = segment.ends.a - from;
    const Point b = segment.ends.b - from;
    const Point along = b - a;
    const std::int64_t determinant = cross(displacement, along);
    if (onlyLeaves && segment.warp && determinant <= 0) return std::nullopt;
    const auto time =
        determinant == 0 ? parallelTime(a, b, displacement) : crossingTime(a, along, displacement, determinant);
    if (!time) return std::nullopt;
    const Point facing = determinant > 0 ? perpendicular(along) : -perpendicular(along);
    return RayHit{segment, *time, determinant == 0 ? -displacement : facing};
  }
};

// Meets a segment with a moving shape.
struct ShapeMeeting {
  const Sweep& sweep;

  using Found = ShapeHit;
  static Fraction timeOf(const ShapeHit& hit) { return hit.hit.time; }
  static std::uint32_t indexOf(const ShapeHit& hit) { return hit.segment.index; }
  std::optional<ShapeHit> operator()(const SegmentRef& segment) const {
    const auto hit = sweep.against(segment.ends);
    return hit ? std::optional(ShapeHit{segment, *hit}) : std::nullopt;
  }
};

// Meets a segment with a shape at rest.
struct OverlapMeeting {
  const Sweep& sweep;

  using Found = SegmentRef;
  static Fraction timeOf(const SegmentRef&) { return {}; }
  static std::uint32_t indexOf(const SegmentRef& segment) { return segment.index; }
  std::optional<SegmentRef> operator()(const SegmentRef& segment) const {
    return sweep.against(segment.ends) ? std::optional(segment) : std::nullopt;
  }
};

// The path of a query through a part.
struct Path {
  const MapGeometry& part;
  Box extent;  // of what moves, relative to its position
  Point from;
  Point displacement;
  SegmentFilter filter;

  bool includes(std::uint32_t segment) const {
    return segment != filter.except && (part.isWarp(segment) ? filter.warps : filter.walls);
  }
  SegmentRef refOf(std::uint32_t segment) const {
    SegmentRef ref{part.id, segment, part.isWarp(segment), part.segments[segment]};
    ref.tag = part.tagOf(segment);
    return ref;
  }
  GridWalk walk() const { return GridWalk(part.grid, extent, from, displacement); }
};

template <class Meeting>
bool isBefore(const typename Meeting::Found& a, const typename Meeting::Found& b) {
  const Fraction time = Meeting::timeOf(a);
  const Fraction other = Meeting::timeOf(b);
  return time < other || (time == other && Meeting::indexOf(a) < Meeting::indexOf(b));
}

template <class Meeting>
std::optional<typename Meeting::Found> findFirst(const Path& path, const Meeting& meeting) {
  std::optional<typename Meeting::Found> first;
  for (GridWalk walk = path.walk(); !walk.isDone(); walk.next()) {
    if (first && Meeting::timeOf(*first) < walk.reached()) break;
    for (const std::uint32_t segment : walk.segments()) {
      if (!path.includes(segment)) continue;
      const auto found = meeting(path.refOf(segment));
      if (found && (!first || isBefore<Meeting>(*found, *first))) first = found;
    }
  }
  return first;
}

template <class Meeting>
void findAll(const Path& path, const Meeting& meeting, std::vector<typename Meeting::Found>& all) {
  all.clear();
  for (GridWalk walk = path.walk(); !walk.isDone(); walk.next()) {
    for (const std::uint32_t segment : walk.segments()) {
      if (!path.includes(segment)) continue;
      if (const auto found = meeting(path.refOf(segment))) all.push_back(*found);
    }
  }
  const auto isSame = [](const auto& a, const auto& b) { return Meeting::indexOf(a) == Meeting::indexOf(b); };
  std::sort(all.begin(), all.end(), isBefore<Meeting>);
  all.erase(std::unique(all.begin(), all.end(), isSame), all.end());
}

Path rayPath(const World& world, std::uint32_t part, Point from, Point displacement, const SegmentFilter& filter) {
  requirePath(from, displacement);
  return {partOf(world, part), {}, from, displacement, filter};
}

// Starts the sweep too.
Path shapePath(const World& world, std::uint32_t part, const Convex& shape, Point from, Point displacement,
               const SegmentFilter& filter, Sweep& sweep) {
  requirePath(from, displacement);
  sweep.start(shape, from, displacement);
  return {partOf(world, part), shape.bounds(), from, displacement, filter};
}

// Whether an edge of `shape` separates it from `other` at `offset`. Bounds: normals < 2^30, coordinates < 2^30 + 2^29.
bool separates(const Convex& shape, const Convex& other, Point offset) {
  return std::any_of(shape.edges().begin(), shape.edges().end(), [&](const Convex::Edge& edge) {
    return std::all_of(other.vertices().begin(), other.vertices().end(),
                       [&](Point vertex) { return dot(edge.normal, vertex + offset) <= edge.support; });
  });
}

}  // namespace

std::optional<RayHit> castRay(const World& world, std::uint32_t part, Point from, Point displacement,
                              const SegmentFilter& filter) {
  return findFirst(rayPath(world, part, from, displacement, filter), RayMeeting{from, displacement});
}

void castRayThrough(const World& world, std::uint32_t part, Point from, Point displacement, std::vector<RayHit>& hits,
                    const SegmentFilter& filter) {
  findAll(rayPath(world, part, from, displacement, filter), RayMeeting{from, displacement}, hits);
}

std::optional<RayOverWarpsHit> castRayOverWarps(const World& world, std::uint32_t part, Point from, Point displacement,
                                                int maxWarps) {
  requirePath(from, displacement);
  PrecisePoint end = precise(from + displacement);
  for (int warps = 0;; ++warps) {
    const Path path = rayPath(world, part, from, displacement, {});
    const auto hit = findFirst(path, RayMeeting{from, displacement, true});
    if (!hit) return std::nullopt;
    if (!hit->segment.warp) return RayOverWarpsHit{*hit, from, displacement, warps};
    const Warp& warp = path.part.warps[path.part.warpOfSegment(hit->segment.index)];
    if (warps >= maxWarps || !world.geometry().reverseWarp(part, warp)) return std::nullopt;
    part = warp.target;
    end = warp.map(end);
    from = rounded(warp.map(pointAt(from, displacement, hit->time)));
    requirePath(rounded(end), {});
    displacement = rounded(end) - from;
  }
}

std::optional<ShapeHit> castShape(const World& world, std::uint32_t part, const Convex& shape, Point from,
                                  Point displacement, const SegmentFilter& filter) {
  Sweep sweep;
  const Path path = shapePath(world, part, shape, from, displacement, filter, sweep);
  return findFirst(path, ShapeMeeting{sweep});
}

void castShapeThrough(const World& world, std::uint32_t part, const Convex& shape, Point from, Point displacement,
                      std::vector<ShapeHit>& hits, const SegmentFilter& filter) {
  Sweep sweep;
  const Path path = shapePath(world, part, shape, from, displacement, filter, sweep);
  findAll(path, ShapeMeeting{sweep}, hits);
}

bool overlapsSegment(const World& world, std::uint32_t part, const Convex& shape, Point position,
                     const SegmentFilter& filter) {
  return castShape(world, part, shape, position, {}, filter).has_value();
}

void findOverlaps(const World& world, std::uint32_t part, const Convex& shape, Point position,
                  std::vector<SegmentRef>& found, const SegmentFilter& filter) {
  Sweep sweep;
  const Path path = shapePath(world, part, shape, position, {}, filter, sweep);
  findAll(path, OverlapMeeting{sweep}, found);
}

bool overlap(const Convex& a, Point positionOfA, const Convex& b, Point positionOfB) {
  const Point offset = positionOfB - positionOfA;
  return !separates(a, b, offset) && !separates(b, a, -offset);
}

PrecisePoint pointAt(Point from, Point displacement, Fraction time) {
  const auto part = [&](std::int32_t whole) {
    const int128 product = int128{whole} * PrecisePoint::kOne * time.numerator;
    return static_cast<std::int64_t>(divideRounded(product, int128{time.denominator}));
  };
  return precise(from) + PrecisePoint{part(displacement.x), part(displacement.y)};
}

}  // namespace platon
