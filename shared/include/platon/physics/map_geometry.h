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

/// A line that leads to another map part: what lies behind `from` there continues behind `onto` here.
struct Warp {
  Segment from;                  ///< in this part; the part lies on its left
  std::uint32_t target = 0;      ///< id of the other part
  Segment onto;                  ///< the same two points in the other part, which lies on its right
  Angle turn;                    ///< what is added to an angle here to get it there
  PrecisePoint fromMiddle = {};  ///< the middle of the line, better than its rounded ends tell
  PrecisePoint ontoMiddle = {};  ///< and where it lies in the other part
};

/// What an initialised map part holds. Immutable, shared by any number of worlds and threads.
struct MapGeometry {
  std::uint32_t id = 0;
  /// Regular lines, then the `from` of every warp.
  std::vector<Segment> segments;
  std::vector<Warp> warps;
  Grid grid;

  bool isWarp(std::uint32_t segment) const { return segment >= segments.size() - warps.size(); }
  std::uint32_t segmentOfWarp(std::uint32_t warp) const {
    return static_cast<std::uint32_t>(segments.size() - warps.size()) + warp;
  }
  std::uint32_t warpOfSegment(std::uint32_t segment) const {
    return segment - static_cast<std::uint32_t>(segments.size() - warps.size());
  }
};

/// All map parts of a world, by ascending id.
struct Geometry {
  std::vector<std::shared_ptr<const MapGeometry>> parts;

  /// Null when there is no such part.
  const MapGeometry* find(std::uint32_t id) const;
  /// The index, in its target, of the warp that leads back over the same segment; none when the target or that warp is
  /// missing. A warp without a way back is a dead end: nothing passes it.
  std::optional<std::uint16_t> reverseWarp(std::uint32_t partId, const Warp& warp) const;
};

/// `geometry` with one more part. Throws std::invalid_argument when the id is taken already.
std::shared_ptr<const Geometry> withPart(const Geometry& geometry, MapGeometry part);

}  // namespace platon
