#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/convex.h"
#include "platon/physics/rules.h"
#include "platon/physics/sweep.h"
#include "platon/physics/world.h"

namespace platon {

// Queries ask what is in a map part, and change nothing. They are exact: only castRayOverWarps and pointAt round. The
// answer does not depend on the grid, on earlier queries or on the machine. None allocates, except to enlarge a vector
// of the caller.
//
// A query sees one map part. Warps are segments of it, and are found like other segments (SegmentRef::warp), unless the
// filter leaves them out. What lies behind a warp is found by a further query in the part behind it: castRayOverWarps
// does that for rays. A shape near an edge should be asked for in every part that it reaches (World::view).
//
// All functions but overlap and pointAt throw std::invalid_argument when the map part is not initialised or when the
// start or the end of the path is out of range: coordinates must be below 2^29 in magnitude.

/// Chooses the segments that a query may find. A further condition, for example that of a Rules::pierce, can be applied
/// to what castRayThrough, castShapeThrough and findOverlaps have found.
struct SegmentFilter {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  bool walls = true;             ///< segments that do not belong to a warp
  bool warps = true;             ///< segments that belong to a warp
  std::uint32_t except = kNone;  ///< index of a segment that is left out
};

/// A segment that a ray meets. A ray is a closed straight line from one lattice point to another; they may be equal. It
/// meets a segment with which it has a point in common: touching counts, and so do ends.
struct RayHit {
  SegmentRef segment;
  Fraction time;  ///< of the first common point, as a fraction of the displacement, in [0, 1]
  Point normal;   ///< of the side of the segment that faces the start, coordinates below 2^30. The reverse of the
                  ///< displacement when the segment is a point or parallel to the ray
};

/// A segment that a moving shape meets, as in Sweep: touching does not count.
struct ShapeHit {
  SegmentRef segment;
  Hit hit;
};

/// The first segment of the part that the ray from `from` to `from + displacement` meets. Of several that are met at
/// the same time, the one with the lowest index.
std::optional<RayHit> castRay(const World& world, std::uint32_t part, Point from, Point displacement,
                              const SegmentFilter& filter = {});
/// Replaces `hits` by all segments that the ray meets, in the order of time, then of their indices.
void castRayThrough(const World& world, std::uint32_t part, Point from, Point displacement, std::vector<RayHit>& hits,
                    const SegmentFilter& filter = {});

/// The first segment that the shape meets on its straight way from `from` to `from + displacement`. Of several that are
/// met at the same time, the one with the lowest index. `shape` is not rotated; see Convex::turned.
std::optional<ShapeHit> castShape(const World& world, std::uint32_t part, const Convex& shape, Point from,
                                  Point displacement, const SegmentFilter& filter = {});
/// Replaces `hits` by all segments that the shape would meet if none stopped it, in the order of time, then of their
/// indices.
void castShapeThrough(const World& world, std::uint32_t part, const Convex& shape, Point from, Point displacement,
                      std::vector<ShapeHit>& hits, const SegmentFilter& filter = {});

/// Whether the shape at `position` overlaps a segment of the part. Touching is not an overlap.
bool overlapsSegment(const World& world, std::uint32_t part, const Convex& shape, Point position,
                     const SegmentFilter& filter = {});
/// Replaces `found` by all segments that the shape at `position` overlaps, in the order of their indices.
void findOverlaps(const World& world, std::uint32_t part, const Convex& shape, Point position,
                  std::vector<SegmentRef>& found, const SegmentFilter& filter = {});

/// A ray that went on over warps: its last leg, in the part in which it ended, and what it met there.
struct RayOverWarpsHit {
  RayHit hit;          ///< a segment that does not belong to a warp
  Point from;          ///< start of the last leg, in the frame of the part of `hit`
  Point displacement;  ///< of the last leg; the time of `hit` is a fraction of it
  int warps = 0;       ///< number of warps that the ray went over
};

/// The first wall that a ray meets which goes on behind warps, as an entity does. The ray leaves a part where it
/// crosses a warp from left to right. It ends at a warp without a reverse warp, and at the next warp after `maxWarps`
/// of them. Exact in the part where it starts. Behind a warp, start and end of a leg are images by Warp::map, each
/// rounded to the lattice, so that a leg is up to 0.71 subunits farther from the exact ray after every warp; within
/// that distance of a corner of the part, it may pass on the other side of the corner. Throws std::invalid_argument
/// also when the image of the end is out of range.
std::optional<RayOverWarpsHit> castRayOverWarps(const World& world, std::uint32_t part, Point from, Point displacement,
                                                int maxWarps);

/// Whether two convex shapes at these positions overlap: whether their open interiors have a common point. Exact, by
/// separating axes (Gottschalk, Lin and Manocha, OBBTree, 1996). Requires coordinates below 2^29 in magnitude.
bool overlap(const Convex& a, Point positionOfA, const Convex& b, Point positionOfB);

/// The point `from + time * displacement`, rounded to 2^-26 subunits. Requires 0 <= time <= 1.
PrecisePoint pointAt(Point from, Point displacement, Fraction time);

}  // namespace platon
