#pragma once

#include "client/netcode/player_snapshot.h"
#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// Pose of a player, which must be present.
Pose poseOf(const SolidMesh& mesh, const PlayerSnapshot& player);

/// Interpolates the pose of a player between two ticks along the surface: linearly within a face, and over an edge
/// linearly in the unfolded faces. Round a vertex, through a third face, the straight line through the solid is
/// projected from the centre onto the surface. Up turns evenly within a face and folds with the faces at an edge. A
/// distance too long for one tick is a jump, such as a restart, and gives the later pose. The player must be present at
/// both ticks.
Pose poseBetween(const SolidMesh& mesh, const InterpolatedPlayer& player);

}  // namespace platon
