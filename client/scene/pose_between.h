#pragma once

#include "client/netcode/player_snapshot.h"
#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// A player where it stands. It must be present.
Pose poseOf(const SolidMesh& mesh, const PlayerSnapshot& player);

/// A player on its way, which leads along the surface: straight and even within a face, and over an edge as if both
/// faces were laid flat. Round a corner, through a third face, it is the line through the solid seen from its centre.
/// Up turns evenly within the face and goes with it over an edge. Ways too long for one tick are jumps, as back to the
/// start, and not drawn in between: the player stands where it went. It must be present at both ends.
Pose poseBetween(const SolidMesh& mesh, const InterpolatedPlayer& player);

}  // namespace platon
