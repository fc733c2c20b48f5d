#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/gl/image.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"

namespace platon {

/// A stage of a solid with `faces` faces, whose face 0 holds the goal and these segments.
inline std::shared_ptr<const StageModel> stageOf(const std::string& solid, int faces,
                                                 const std::string& segmentsOfFace0) {
  std::string text = solid + "\n0 0 0 0\n0 60 80\n480\n%\n" + segmentsOfFace0;
  for (int face = 1; face < faces; ++face) text += "%\n";
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return makeStageModel(*result.level);
}

inline std::shared_ptr<const StageModel> cube() { return stageOf("HEXAHEDRON", 6, "-200 -120 -60 -120\n"); }

inline PlayerDrawing playerAt(const StageModel& stage, std::uint32_t slot, int face, glm::dvec2 place) {
  PlayerDrawing player;
  player.slot = slot;
  player.pose = stage.mesh.pose(face, place, 0);
  player.colour = playerColour(slot);
  player.pattern = appearanceOfSlot(slot).pattern;
  player.number = std::to_string(slot + 1);
  return player;
}

/// A scene that looks at the centre of face 0.
inline Scene sceneOf(const std::shared_ptr<const StageModel>& stage, std::vector<PlayerDrawing> players = {}) {
  Scene scene;
  scene.stage = stage;
  scene.players = std::move(players);
  scene.focus = stage->mesh.pose(0, {0, 0}, 0);
  return scene;
}

/// The colour of a pixel, each component in [0, 1].
inline glm::vec3 pixel(const Image& image, glm::ivec2 at) {
  const std::size_t first = 3 * (static_cast<std::size_t>(at.y) * image.width + static_cast<std::size_t>(at.x));
  return glm::vec3(image.pixels[first], image.pixels[first + 1], image.pixels[first + 2]) / 255.0F;
}

inline double brightness(glm::vec3 colour) { return (colour.r + colour.g + colour.b) / 3; }

}  // namespace platon
