#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/element.h"
#include "platon/game/solid.h"
#include "platon/physics/segment.h"
#include "platon/physics/world.h"

namespace platon {

/// The post at a corner of a face: the segments that block the corner. A shape must never contain a vertex of the
/// solid: its placement would be ambiguous there, and a chain of warps around the vertex would have no end. The corner
/// is a blocking point, which prevents this. The cut, a segment across the corner with its ends on both edges, keeps
/// shapes farther from the vertex than every margin by which instances are inserted early or placed inexactly.
struct Post {
  Segment cut;  ///< from the edge that ends at the corner to the edge that begins there
  Point corner;
};

/// Distance of the ends of a cut from the corner, in subunits along the edges. The cut keeps at least 56 * cos(54°) =
/// 32.9 subunits from the corner (on the pentagon, which has the widest corners). It is too short to be seen on any
/// face.
inline constexpr std::int32_t kPostReach = 56;

/// The posts of a face, in the order of its corners.
std::vector<Post> postsOf(SolidKind kind, std::int32_t faceSize);

/// Returns a world with every face of the solid as a map part (id = face index). A part has the segments of its face,
/// then the cut and the corner of each post, then one warp per edge (warp index = edge index). `segments` holds the
/// segments of each face, inside that face.
World buildStage(SolidKind kind, std::int32_t faceSize, std::span<const std::vector<Segment>> segments);

/// True when a player fits at this position and angle: no segment of `face`, or of a face that the shape reaches over
/// an edge, overlaps it, except elements that never block. `world` comes from buildStage, and `elements` are those of
/// its segments.
bool isFreeForPlayer(const World& world, std::span<const Element> elements, std::uint32_t face, Point position,
                     Angle angle);

}  // namespace platon
