#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "platon/exact/fraction.h"
#include "platon/physics/convex.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"

namespace platon {

/// The first meeting of a moving shape with a line.
struct Hit {
  /// Which edge of the obstacle was entered.
  enum class Side : std::uint8_t {
    kInside,      ///< none: the shape overlapped the line already
    kSegment,     ///< a side of the line, with a vertex or a parallel edge of the shape
    kSegmentEnd,  ///< an end of the line (or a point), with an edge of the shape
  };

  Fraction time;  ///< of the displacement, in [0, 1)
  Fraction exit;  ///< when the shape leaves the line again, later than `time`; at most 1, which means later
  Point normal;   ///< outward normal of the edge entered; (0, 0) when inside. Below 2^30 a coordinate
  Point feature;  ///< what touches: kSegment, a vertex of the shape, relative to its position; kSegmentEnd, the end
  Side side = Side::kInside;
};

/// The exact swept test: a convex shape S moves from `position` along `displacement`; a line L forbids the open
/// polygon L + (-S). The displacement is clipped against the edges of that polygon. No rounding anywhere.
///
/// Bounds: coordinates < 2^29, so |normal| < 2^30, normal . vertex and normal . position < 2^60 each and every signed
/// speed below is < 2^61, every signed distance < 1.5 * 2^62. Times compare through 128 bits.
class Sweep {
 public:
  /// When a displacement is inside an obstacle, by which edge it gets there, and whether it is there in the end.
  struct Meeting {
    static constexpr std::size_t kNone = ~std::size_t{0};

    Fraction enter{0, 1};
    Fraction exit{1, 1};
    std::size_t entered = kNone;  ///< index of a half plane; none when it is inside from the beginning
    bool endsInside = true;
  };

  /// Prepares for any number of lines. `grown` > 0 moves every edge of the obstacle outwards by at least that many
  /// subunits (by grown * (|nx| + |ny|) / |n|). The shape must outlive the sweep.
  void start(const Convex& shape, Point position, Point displacement, std::int32_t grown = 0) {
    shape_ = &shape;
    position_ = position;
    displacement_ = displacement;
    grown_ = grown;
    way_ = Box{position, position}.swept(displacement);
    const Point margin(grown, grown);
    bounds_ = {way_.low + shape.bounds().low - margin, way_.high + shape.bounds().high + margin};
  }

  /// The first meeting with `line`: the infimum of the times in [0, 1] at which the open shape meets it. Touching, and
  /// a meeting that begins at time 1, are none. Where two edges are entered at once, the sides of the line win over
  /// its ends and earlier edges of the shape over later ones.
  std::optional<Hit> against(const Segment& line) const;
  /// The same; `obstacle` must be of the shape.
  std::optional<Hit> against(Obstacle& obstacle) const;

  /// Both parts of `against`: whether and when, then what touches. Lines that `misses` are not asked for.
  std::optional<Meeting> meet(Obstacle& obstacle) const {
    // Of most lines nearby the same edge keeps the shape away, step by step: that is told at once.
    const Course likely = courseOf(obstacle.halfPlanes()[obstacle.separatingHint()]);
    if (likely.start >= 0 && likely.end >= 0) return std::nullopt;
    return clip(obstacle);
  }
  static Hit describe(const Obstacle& obstacle, const Meeting& meeting);

  /// Whether the moving shape stays away from a line within these bounds.
  bool misses(const Box& boundsOfLine) const { return !bounds_.overlaps(boundsOfLine); }
  /// All that the moving shape passes over, grown.
  const Box& bounds() const { return bounds_; }

 private:
  // The signed distances from a half plane, grown, at both ends of the displacement, times the length of the normal.
  struct Course {
    std::int64_t start;
    std::int64_t end;
  };
  Course courseFrom(std::int64_t start, const Obstacle::HalfPlane& half) const {
    if (grown_ != 0) start -= std::int64_t{half.slope()} * grown_;
    return {start, start + dot(half.normal, displacement_)};
  }
  Course courseOf(const Obstacle::HalfPlane& half) const {
    return courseFrom(dot(half.normal, position_) + half.offset, half);
  }
  // One half plane more: false when it shuts out all of the way.
  static bool clip(Meeting& meeting, Course course, std::size_t halfPlane) {
    if (course.start < 0 && course.end < 0) return true;
    if (course.start >= 0 && course.end >= 0) return false;
    cross(meeting, course, halfPlane);
    return true;
  }
  static void cross(Meeting& meeting, Course course, std::size_t halfPlane);
  static bool isEmpty(const Meeting& meeting);
  std::optional<Meeting> clip(Obstacle& obstacle) const;

  const Convex* shape_ = nullptr;
  Point position_;
  Point displacement_;
  std::int32_t grown_ = 0;
  Box way_;  // of the position
  Box bounds_;
};

}  // namespace platon
