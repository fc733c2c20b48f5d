#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "platon/exact/fraction.h"
#include "platon/physics/convex.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"

namespace platon {

/// The first collision of a moving shape with a segment.
struct Hit {
  /// The kind of obstacle edge that was entered.
  enum class Side : std::uint8_t {
    kInside,      ///< none: the shape overlapped the segment at the start
    kSegment,     ///< a side of the segment touches a vertex or a parallel edge of the shape
    kSegmentEnd,  ///< an end of the segment (or a point) touches an edge of the shape
  };

  Fraction time;  ///< start of the overlap as a fraction of the displacement, in [0, 1)
  Fraction exit;  ///< end of the overlap, in (time, 1]; 1/1 when the overlap lasts to the end of the displacement
  Point normal;   ///< outward normal of the entered edge, coordinates below 2^30; (0, 0) for kInside
  Point feature;  ///< kSegment: see Obstacle::sideFeature; kSegmentEnd: the touching end of the segment
  Side side = Side::kInside;
};

/// Exact swept collision test. A convex shape S moves from `position` along `displacement`; its position must not enter
/// the open polygon L + (-S) of a segment L (see Obstacle). The displacement is clipped against the half planes of that
/// polygon (Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, 1978). No value is rounded.
///
/// Bounds: with coordinates < 2^29, |normal| < 2^30; dot(normal, vertex) and dot(normal, position) are < 2^60,
/// dot(normal, displacement) < 2^61, and signed distances < 1.5 * 2^62. Times are compared in 128 bits.
class Sweep {
 public:
  /// The part of the displacement that is inside an obstacle.
  struct ClipInterval {
    static constexpr std::size_t kNone = ~std::size_t{0};

    Fraction enter{0, 1};
    Fraction exit{1, 1};
    std::size_t entered = kNone;  ///< index of the half plane crossed at `enter`; kNone when inside at the start
    bool endsInside = true;       ///< whether the end of the displacement is inside
  };

  /// Prepares tests against any number of segments. A `margin` > 0 moves every edge of the obstacles outwards by
  /// margin * (|nx| + |ny|) / |n| subunits, where n is its normal: at least `margin`. The shape must outlive the sweep.
  void start(const Convex& shape, Point position, Point displacement, std::int32_t margin = 0) {
    shape_ = &shape;
    position_ = position;
    displacement_ = displacement;
    margin_ = margin;
    path_ = Box{position, position}.swept(displacement);
    const Point grown(margin, margin);
    bounds_ = {path_.low + shape.bounds().low - grown, path_.high + shape.bounds().high + grown};
  }

  /// The first collision with `segment`; `time` is the infimum of the times in [0, 1] at which the open shape overlaps
  /// it. Touching is not a collision, nor is an overlap that begins at time 1. When several edges are entered at the
  /// same time, sides of the segment take precedence over its ends, and earlier edges of the shape over later ones.
  std::optional<Hit> against(const Segment& segment) const;
  /// As above with a prebuilt obstacle, which must belong to the shape of this sweep.
  std::optional<Hit> against(Obstacle& obstacle) const;

  /// First half of `against`: clips the displacement against the obstacle. Nothing when they do not overlap. The bounds
  /// of the segment must not be missed (see `misses`).
  std::optional<ClipInterval> clip(Obstacle& obstacle) const {
    // Fast path: the half plane that excluded the last displacement usually excludes this one.
    if (isExcluded(obstacle.separatingHalfPlane())) return std::nullopt;
    return clipToHalfPlanes(obstacle);
  }
  /// Whether the whole displacement is outside one half plane of an obstacle, and so outside the obstacle.
  bool isExcluded(const Obstacle::HalfPlane& half) const {
    const EndDistances distances = endDistancesTo(half);
    return distances.start >= 0 && distances.end >= 0;
  }
  /// As `clip`, without a prebuilt obstacle. When one half plane of the obstacle alone excludes the displacement,
  /// writes it to `separating`.
  std::optional<ClipInterval> clip(const Segment& segment, Obstacle::HalfPlane& separating) const;
  /// Second half of `against`: the collision that belongs to the result of `clip`, or to an interval that only has
  /// `enter` and `entered`; its `exit` then means nothing.
  static Hit hitOf(const Obstacle& obstacle, const ClipInterval& interval);
  static Hit hitOf(const Convex& shape, const Segment& segment, const ClipInterval& interval);

  /// Whether the bounding box of the moving shape is disjoint from the bounding box of a segment.
  bool misses(const Box& segmentBounds) const { return !bounds_.overlaps(segmentBounds); }
  /// Bounding box of the shape over the whole displacement, including the margin.
  const Box& bounds() const { return bounds_; }
  /// Bounding box of the positions along the displacement.
  const Box& path() const { return path_; }

 private:
  // Signed distances from a half plane at both ends of the displacement, times the length of its normal.
  struct EndDistances {
    std::int64_t start;
    std::int64_t end;
  };
  EndDistances endDistances(std::int64_t start, const Obstacle::HalfPlane& half) const {
    if (margin_ != 0) start -= std::int64_t{half.oneNorm()} * margin_;
    return {start, start + dot(half.normal, displacement_)};
  }
  EndDistances endDistancesTo(const Obstacle::HalfPlane& half) const {
    return endDistances(dot(half.normal, position_) + half.offset, half);
  }
  // Intersects `interval` with a half plane. False when the half plane excludes the whole displacement.
  static bool intersect(ClipInterval& interval, EndDistances distances, std::size_t halfPlane) {
    if (distances.start < 0 && distances.end < 0) return true;
    if (distances.start >= 0 && distances.end >= 0) return false;
    cross(interval, distances, halfPlane);
    return true;
  }
  static void cross(ClipInterval& interval, EndDistances distances, std::size_t halfPlane);
  static bool isEmpty(const ClipInterval& interval);
  std::optional<ClipInterval> clipToHalfPlanes(Obstacle& obstacle) const;
  template <class Separates>
  std::optional<ClipInterval> clipToSegment(const Segment& segment, Separates&& separates) const;

  const Convex* shape_ = nullptr;
  Point position_;
  Point displacement_;
  std::int32_t margin_ = 0;
  Box path_;  // bounding box of the positions
  Box bounds_;
};

}  // namespace platon
