#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "client/audio/sound_cues.h"
#include "client/scene/solid_mesh.h"
#include "levels/drawing/solid_frame.h"
#include "platon/game/game.h"

namespace platon {

inline Pose poseOf(const Game& game, std::uint32_t slot, const SolidMesh& mesh) {
  const EntityState& entity = game.world().entities()[slot];
  return mesh.pose(static_cast<int>(entity.part), toUnits(entity.position), toRadians(entity.angle));
}

inline ObservedPlayer observe(const Game& game, std::uint32_t slot, const SolidMesh& mesh) {
  return {game.tick(), game.player(slot), game.world().entities()[slot], poseOf(game, slot, mesh)};
}

/// A cube of edge 480 with the start at (−150, −150) of face 0 and a floor on each face, and `segments` on face 0.
inline std::shared_ptr<const Level> cubeWith(const std::string& segments) {
  std::string text = "HEXAHEDRON\n0 -150 -150 0\n5 0 100\n480\n";
  for (int face = 0; face < 6; ++face) text += "%\n-240 -200 240 -200\n" + (face == 0 ? segments : "");
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

}  // namespace platon
