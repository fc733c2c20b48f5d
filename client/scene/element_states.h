#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/solid_mesh.h"
#include "platon/game/game.h"

namespace platon {

/// What changes in the picture of the elements during a game. The lists are empty in a level without elements.
struct ElementStates {
  /// By Level::elements, 1: the `up` blocks the local player; the local player returns to the checkpoint; the key can
  /// be taken; the door is closed; the doors of the plate are open; the timed segment is solid. Always 1 for other
  /// kinds.
  std::vector<std::uint8_t> active;
  /// By Level::elements: how full the clock of a timed segment is, 0 … 1. It empties while the segment is solid, and
  /// fills while it is open. 0 for other kinds.
  std::vector<float> clocks;
  std::vector<glm::vec2> ups;  ///< by face: the local player's up, carried there; unit, in the frame of the face
};

/// The up of `pose` when it is carried to `face`, in the frame of that face: over the common edge, and to a face that
/// is no neighbour by the smallest rotation. On the opposite face, which is never seen: +y.
glm::dvec2 carriedUp(const SolidMesh& mesh, const Pose& pose, int face);

/// The edge to which an up on a face with so many edges points, as pointsTo decides it for `up` elements.
int edgeTowards(glm::dvec2 up, int edges);

/// The states that `local`, the slot of a player of `game`, sees. Without a player there, those at the start.
ElementStates elementStatesOf(const Game& game, std::optional<std::uint32_t> local, const SolidMesh& mesh);

}  // namespace platon
