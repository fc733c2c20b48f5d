#include "shared/physics/ideal_geometry.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "shared/physics/tolerances.h"

namespace platon {
namespace {

int128 dotPrecise(Point normal, PrecisePoint point) { return int128{normal.x} * point.x + int128{normal.y} * point.y; }

int widthOf(int128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

// tangent * along / |tangent|^2. Bounds: |along| < 2^88, |tangent| < 2^30.
PrecisePoint multipleOf(Point tangent, int128 along) {
  const int128 length = squaredLength(tangent);
  return {static_cast<std::int64_t>(divideRounded(along * tangent.x, length)),
          static_cast<std::int64_t>(divideRounded(along * tangent.y, length))};
}

// The range, along perpendicular(normal), of the vertices with the smallest dot(normal, vertex): one or two neighbours.
std::pair<std::int64_t, std::int64_t> deepestAlong(const Convex& shape, Point normal) {
  const std::vector<Point>& vertices = shape.vertices();
  std::size_t deepest = 0;
  std::int64_t depth = dot(normal, vertices[0]);
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const std::int64_t here = dot(normal, vertices[i]);
    deepest = here < depth ? i : deepest;
    depth = std::min(here, depth);
  }
  const Point next = vertices[deepest + 1 == vertices.size() ? 0 : deepest + 1];
  const Point previous = vertices[deepest == 0 ? vertices.size() - 1 : deepest - 1];
  const Point tangent = perpendicular(normal);
  const std::int64_t along = dot(tangent, vertices[deepest]);
  // Counter-clockwise, the lower side of a shape is passed against the tangent of a normal that points up.
  const std::int64_t first = dot(normal, next) == depth ? dot(tangent, next) : along;
  const std::int64_t last = dot(normal, previous) == depth ? dot(tangent, previous) : along;
  return {std::min(first, last), std::max(first, last)};
}

std::size_t sideCount(const Segment& segment) { return segment.a == segment.b ? 0 : 2; }

template <class Visit>
void visitHalfPlanes(const Convex& shape, const Segment& segment, Visit&& visit) {
  std::size_t index = 0;
  if (sideCount(segment) > 0) {
    for (const Obstacle::HalfPlane& side : Obstacle::sideHalfPlanes(shape, segment)) {
      if (!visit(index++, side)) return;
    }
  }
  for (const Convex::Edge& edge : shape.edges()) {
    if (!visit(index++, Obstacle::edgeHalfPlane(edge, segment))) return;
  }
}

// Clips a path against half planes of one obstacle (Cyrus-Beck).
class IdealClip {
 public:
  IdealClip(std::size_t sides, PrecisePoint from, PrecisePoint displacement)
      : sides_(sides), from_(from), displacement_(displacement) {}

  // Returns false if the whole path is outside of the half plane.
  bool intersect(std::size_t index, const Obstacle::HalfPlane& half) {
    const Crossing crossing{half, index, distanceTo(half, from_), dotPrecise(half.normal, displacement_)};
    const int128 tolerance = crossing.tolerance();
    const bool endsInside = crossing.start + crossing.change < -tolerance;
    if (crossing.start >= -tolerance) {
      if (!endsInside) return false;
      enter(crossing);
    } else if (!endsInside) {
      leave(crossing);
    }
    return true;
  }

  bool startsInside() const { return interval_.entered == Sweep::ClipInterval::kNone; }

  // Of a path that starts inside: whether this edge is nearer to the start than all before.
  void findNearest(std::size_t index, const Obstacle::HalfPlane& half) {
    const Fraction depth = fractionOf(-distanceTo(half, from_), half.oneNorm());
    if (!startsInside() && depth >= depth_) return;
    depth_ = depth;
    interval_.entered = index;
    isLeaving_ = dotPrecise(half.normal, displacement_) >= 0;
  }

  std::optional<IdealEntry> result() const {
    const bool isEmpty = !interval_.endsInside && interval_.enter >= interval_.exit;
    if (startsInside() || isLeaving_ || isEmpty) return std::nullopt;
    return IdealEntry{interval_.enter, interval_.entered};
  }

 private:
  struct Crossing {
    Obstacle::HalfPlane half{};
    std::size_t index = 0;
    int128 start = 0;   // distance, as distanceTo
    int128 change = 0;  // of the distance, along the path

    int128 tolerance() const { return int128{Tolerances::kOnEdge} * half.oneNorm(); }
    // When an entering path is on the edge, and when it comes within the tolerance of it and leaves it.
    Fraction time() const { return start <= tolerance() ? Fraction{0, 1} : fractionOf(start, -change); }
    Fraction early() const { return fractionOf(start - tolerance(), -change); }
    Fraction late() const { return fractionOf(start + tolerance(), -change); }
    // When a leaving path comes within the tolerance of the edge. So the interval of a path that only touches a corner
    // is empty.
    Fraction leaveTime() const { return fractionOf(-start - tolerance(), change); }
  };

  // Of several edges that the path enters at one place, a side of the segment counts, or else the one with which the
  // path makes the smallest angle. A place is one where the path is on both edges at once: at small angles, the exact
  // times may differ by much more than the tolerance.
  void enter(const Crossing& crossing) {
    const Fraction time = crossing.time();
    const bool isLater = startsInside() || time > interval_.enter;
    const bool counts =
        startsInside() || !entersWith(crossing, isLater) ? isLater : takesPrecedence(crossing, entered_);
    if (isLater) interval_.enter = time;
    if (!counts) return;
    entered_ = crossing;
    interval_.entered = crossing.index;
  }

  // Whether the path enters this edge and the one of entered_ at one place.
  bool entersWith(const Crossing& crossing, bool isLater) const {
    return isLater ? crossing.early() <= entered_.late() : entered_.early() <= crossing.late();
  }

  void leave(const Crossing& crossing) {
    const Fraction time = crossing.leaveTime();
    if (interval_.endsInside || time < interval_.exit) interval_.exit = time;
    interval_.endsInside = false;
  }

  // The angles are compared to 30 bits. Bounds: the changes keep 30 bits, so that the products are < 2^60 * 2^61.
  bool takesPrecedence(const Crossing& a, const Crossing& b) const {
    if ((a.index < sides_) != (b.index < sides_)) return a.index < sides_;
    const int shift = std::max(std::max(widthOf(-a.change), widthOf(-b.change)) - 30, 0);
    const int128 steepA = a.change >> shift;
    const int128 steepB = b.change >> shift;
    return steepA * steepA * squaredLength(b.half.normal) < steepB * steepB * squaredLength(a.half.normal);
  }

  std::size_t sides_;  // their indices come first
  PrecisePoint from_;
  PrecisePoint displacement_;
  Sweep::ClipInterval interval_;
  Crossing entered_;
  Fraction depth_{0, 1};  // of the start, behind the nearest edge, times the one-norm of its normal
  bool isLeaving_ = false;
};

// The result of a clip with all half planes that the path crosses.
std::optional<IdealEntry> resultOf(IdealClip& clip, const Convex& shape, const Segment& segment) {
  if (clip.startsInside()) {
    visitHalfPlanes(shape, segment, [&](std::size_t index, const Obstacle::HalfPlane& half) {
      clip.findNearest(index, half);
      return true;
    });
  }
  return clip.result();
}

}  // namespace

Fraction fractionOf(int128 numerator, int128 denominator) {
  if (numerator <= 0) return {0, 1};
  const int shift = std::max(std::max(widthOf(numerator), widthOf(denominator)) - 62, 0);
  return {static_cast<std::int64_t>(numerator >> shift),
          std::max<std::int64_t>(1, static_cast<std::int64_t>(denominator >> shift))};
}

PrecisePoint scaledInside(PrecisePoint vector, Fraction share) {
  const auto scale = [&](std::int64_t value) {
    return static_cast<std::int64_t>(divideRounded(int128{value} * share.numerator, int128{share.denominator}));
  };
  return {scale(vector.x), scale(vector.y)};
}

int128 distanceTo(const Obstacle::HalfPlane& half, PrecisePoint point) {
  return dotPrecise(half.normal, point) + int128{half.offset} * PrecisePoint::kOne;
}

Obstacle::HalfPlane halfPlaneOf(const Convex& shape, const Segment& segment, std::size_t wanted) {
  Obstacle::HalfPlane found{};
  visitHalfPlanes(shape, segment, [&](std::size_t index, const Obstacle::HalfPlane& half) {
    if (index == wanted) found = half;
    return index != wanted;
  });
  return found;
}

std::optional<IdealEntry> clipIdeal(const Convex& shape, const Segment& segment, PrecisePoint from,
                                    PrecisePoint displacement) {
  IdealClip clip(sideCount(segment), from, displacement);
  bool misses = false;
  visitHalfPlanes(shape, segment, [&](std::size_t index, const Obstacle::HalfPlane& half) {
    misses = !clip.intersect(index, half);
    return !misses;
  });
  return misses ? std::nullopt : resultOf(clip, shape, segment);
}

// IdealClip would find the same: of the other half planes, the path leaves some, later. Where an edge of the shape lies
// on the segment, the side of the segment and that edge are one line, and the side counts, which is first.
std::optional<std::size_t> touchedEdge(Obstacle& obstacle, const Box& positions, PrecisePoint from,
                                       PrecisePoint displacement) {
  std::optional<std::size_t> touched;
  const bool isAlone = obstacle.visitRelevant(positions, [&](std::size_t index) {
    const Obstacle::HalfPlane half = obstacle.halfPlane(index);
    const int128 start = distanceTo(half, from);
    if (start < -int128{half.oneNorm()} * PrecisePoint::kOne) return true;
    const int128 tolerance = int128{Tolerances::kOnEdge} * half.oneNorm();
    const bool isOn = start >= -tolerance && start <= tolerance;
    const bool isOther = touched && cross(obstacle.halfPlane(*touched).normal, half.normal) != 0;
    if (isOther || !isOn || start + dotPrecise(half.normal, displacement) >= -tolerance) return false;
    if (!touched) touched = index;
    return true;
  });
  return isAlone ? touched : std::nullopt;
}

std::optional<IdealEntry> clipIdeal(Obstacle& obstacle, const Box& positions, PrecisePoint from,
                                    PrecisePoint displacement) {
  IdealClip clip(obstacle.sideCount(), from, displacement);
  const bool mayEnter = obstacle.visitRelevant(positions, [&](std::size_t index) {
    if (clip.intersect(index, obstacle.halfPlane(index))) return true;
    obstacle.setSeparatingHint(index);
    return false;
  });
  return mayEnter ? resultOf(clip, obstacle.shape(), obstacle.segment()) : std::nullopt;
}

ObstacleEdge edgeOf(const Convex& shape, const Segment& segment, const Obstacle::HalfPlane& half) {
  const Point normal = half.normal;
  const Point tangent = perpendicular(normal);
  ObstacleEdge edge{half};
  const std::int64_t a = dot(normal, segment.a);
  const std::int64_t b = dot(normal, segment.b);
  const std::int64_t alongA = dot(tangent, segment.a);
  const std::int64_t alongB = dot(tangent, segment.b);
  edge.low = a == b ? std::min(alongA, alongB) : a > b ? alongA : alongB;
  edge.high = a == b ? std::max(alongA, alongB) : edge.low;
  const auto [first, last] = deepestAlong(shape, normal);
  edge.low -= last;
  edge.high -= first;
  return edge;
}

std::size_t adjacent(const Convex& shape, const Segment& segment, Point normal, bool back) {
  std::size_t best = Sweep::ClipInterval::kNone;
  Point bestNormal;
  visitHalfPlanes(shape, segment, [&](std::size_t index, const Obstacle::HalfPlane& half) {
    const std::int64_t turn = back ? cross(half.normal, normal) : cross(normal, half.normal);
    const std::int64_t nearer = back ? cross(bestNormal, half.normal) : cross(half.normal, bestNormal);
    if (turn <= 0 || (best != Sweep::ClipInterval::kNone && nearer <= 0)) return true;
    best = index;
    bestNormal = half.normal;
    return true;
  });
  return best;
}

PrecisePoint alongEdge(Point normal, PrecisePoint displacement) {
  const Point tangent = perpendicular(normal);
  return multipleOf(tangent, dotPrecise(tangent, displacement));
}

SlideRoom roomOn(const ObstacleEdge& edge, PrecisePoint from, PrecisePoint remaining) {
  const Point tangent = perpendicular(edge.half.normal);
  const int128 along = dotPrecise(tangent, remaining);
  const int128 here = dotPrecise(tangent, from);
  if (along < 0) return {-along, here - int128{edge.low} * PrecisePoint::kOne, true};
  return {along, int128{edge.high} * PrecisePoint::kOne - here, false};
}

EdgeSlide slideAlong(const ObstacleEdge& edge, PrecisePoint from, PrecisePoint remaining) {
  const SlideRoom room = roomOn(edge, from, remaining);
  const int128 used = room.isEnough() ? room.wanted : std::max<int128>(room.left, 0);
  EdgeSlide slide;
  slide.back = room.back;
  slide.cut = !room.isEnough();
  if (slide.cut) slide.share = fractionOf(used, room.wanted);
  slide.displacement = multipleOf(perpendicular(edge.half.normal), room.back ? -used : used);
  return slide;
}

PrecisePoint putOnto(const Obstacle::HalfPlane& half, PrecisePoint point) {
  const int128 distance = distanceTo(half, point);
  const int128 rounding = int128{Tolerances::kRounding} * half.oneNorm();
  if (distance >= -rounding && distance <= rounding) return point;
  const int128 length = squaredLength(half.normal);
  return point - PrecisePoint{static_cast<std::int64_t>(divideRounded(distance * half.normal.x, length)),
                              static_cast<std::int64_t>(divideRounded(distance * half.normal.y, length))};
}

}  // namespace platon
