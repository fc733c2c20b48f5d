#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "client/scene/pose.h"
#include "client/scene/solid_mesh.h"
#include "platon/game/game.h"

namespace platon {

/// What changes in the picture of the elements during a game. Both lists are empty in a level without elements.
struct ElementStates {
  /// By Level::elements, 1: the `up` blocks the local player; the local player returns to the checkpoint; the key can
  /// be taken; the door is closed; the doors of the plate are open. Always 1 for other kinds.
  std::vector<std::uint8_t> active;
  std::vector<int> upEdges;  ///< by face: the edge to which the local player's up points
};

/// The edge of `face` to which the up of `pose` points when it is carried there, as pointsTo decides it for `up`
/// elements. On a face that is no neighbour, the up is carried by the smallest rotation.
int edgeTowards(const SolidMesh& mesh, const Pose& pose, int face);

/// The states that `local`, the slot of a player of `game`, sees. Without a player there, those at the start.
ElementStates elementStatesOf(const Game& game, std::optional<std::uint32_t> local, const SolidMesh& mesh);

}  // namespace platon
