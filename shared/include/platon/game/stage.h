#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/solid.h"
#include "platon/physics/segment.h"
#include "platon/physics/world.h"

namespace platon {

/// What blocks a corner of a face. No shape may have a vertex of the solid inside: there its placement would be
/// ambiguous, and a chain of warps would run round the vertex for ever. The corner itself is a blocking point, so that
/// this can never happen. The cut is a line across the corner, whose ends lie on both edges: it keeps shapes farther
/// from the vertex than every margin by which instances are inserted early or placed inexactly.
struct Post {
  Segment cut;  ///< from the edge that ends at the corner to the edge that begins there
  Point corner;
};

/// How far from the corner the ends of a cut are, along the edges, in subunits. On the pentagon, whose corners are the
/// widest, the cut then keeps 56 * cos(54°) = 32.9 from the corner; too short to see on any face.
inline constexpr std::int32_t kPostReach = 56;

/// One for each corner of a face, in their order.
std::vector<Post> postsOf(SolidKind kind, std::int32_t faceSize);

/// A world with every face of the solid as a map part (id = face index): the face's lines, then for each post its cut
/// and its corner, then one warp for each edge (warp index = edge index). `lines` by face, inside their faces.
World buildStage(SolidKind kind, std::int32_t faceSize, std::span<const std::vector<Segment>> lines);

/// True when a player may stand there: no blocking line, of this face or of one that its shape reaches over the edges,
/// overlaps it. `world` is a stage.
bool isFreeForPlayer(World world, std::uint32_t face, Point position, Angle angle);

}  // namespace platon
