#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/precise_point.h"
#include "platon/physics/grid.h"
#include "platon/physics/segment.h"

namespace platon {

/// A directed segment that connects two map parts: the surface continues across it into the target part. The map from
/// one frame into the other is the isometry that rotates by `turn` and takes `fromMiddle` to `ontoMiddle`.
struct Warp {
  Segment from;                          ///< in this part, which is on its left
  std::uint32_t target = 0;              ///< id of the target part
  Segment onto;                          ///< the same two points in the target part, which is on its right
  Angle turn;                            ///< added to an angle in this part, gives the angle in the target part
  PrecisePoint fromMiddle = {};          ///< midpoint of `from`, more exact than its rounded ends
  PrecisePoint ontoMiddle = {};          ///< the same point in the target part
  Rotation rotation = rotationOf(turn);  ///< follows from `turn`; saves the look-up in every `map`

  /// Maps `point` from the frame of this part into the frame of the target, rounded to 2^-26 subunits. Products
  /// are formed in 128 bits. Requires |point| < 2^56 per coordinate, in 2^-26 subunits.
  PrecisePoint map(PrecisePoint point) const;
  /// The inverse of `map`, up to rounding and 2^-28 of the distance from the midpoint.
  PrecisePoint mapBack(PrecisePoint point) const;

  friend bool operator==(const Warp&, const Warp&) = default;
};

/// The geometry of an initialised map part. Immutable; may be shared by any number of worlds and threads.
struct MapGeometry {
  std::uint32_t id = 0;
  /// The segments added by MapPart::line, followed by the `from` segment of every warp.
  std::vector<Segment> segments;
  std::vector<Warp> warps;
  Grid grid;
  /// By index of the segment: the tag from MapPart::line. Those behind the end are 0, and the last element is not 0.
  std::vector<std::uint32_t> tags = {};

  /// Whether the segment with this index belongs to a warp.
  bool isWarp(std::uint32_t segment) const { return segment >= segments.size() - warps.size(); }
  /// Index of the segment that belongs to the warp with this index.
  std::uint32_t segmentOfWarp(std::uint32_t warp) const {
    return static_cast<std::uint32_t>(segments.size() - warps.size()) + warp;
  }
  /// Inverse of segmentOfWarp. Requires isWarp(segment).
  std::uint32_t warpOfSegment(std::uint32_t segment) const {
    return segment - static_cast<std::uint32_t>(segments.size() - warps.size());
  }

  /// The tag of the segment with this index.
  std::uint32_t tagOf(std::uint32_t segment) const { return segment < tags.size() ? tags[segment] : 0; }

  /// Compares ids, segments, warps and tags, each in their order. The grid follows from the segments.
  friend bool operator==(const MapGeometry& a, const MapGeometry& b) {
    return a.id == b.id && a.segments == b.segments && a.warps == b.warps && a.tags == b.tags;
  }
};

/// All map parts of a world, sorted by id.
struct Geometry {
  std::vector<std::shared_ptr<const MapGeometry>> parts;

  /// The part with this id, or null when there is none.
  const MapGeometry* find(std::uint32_t id) const;
  /// Index, in the target part, of the warp that leads back across the same segment. Nothing when the target or that
  /// warp does not exist; entities cannot pass such a warp.
  std::optional<std::uint16_t> reverseWarp(std::uint32_t partId, const Warp& warp) const;

  /// Compares the content of all parts. Fast where both share a part, as copies of a world do.
  friend bool operator==(const Geometry& a, const Geometry& b);
};

/// A copy of `geometry` with `part` added. Throws std::invalid_argument when a part with the same id exists.
std::shared_ptr<const Geometry> withPart(const Geometry& geometry, MapGeometry part);

}  // namespace platon
