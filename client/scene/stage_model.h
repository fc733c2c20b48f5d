#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/palette.h"
#include "client/scene/solid_mesh.h"
#include "platon/game/level.h"
#include "platon/game/player.h"

namespace platon {

/// A line drawn as a ribbon on its face; level units in the face's frame.
struct Ribbon {
  glm::vec2 a{0};
  glm::vec2 b{0};
};

/// A face and what lies on it for good.
struct FaceDrawing {
  Colour colour{0};
  std::string label;            ///< its index, as in the level file; a dot where it could be read upside down
  std::vector<Ribbon> ribbons;  ///< also those parts of a neighbour's ribbons that reach over the edge
};

/// A place on a face.
struct Marker {
  int face = 0;
  glm::vec2 place{0};
  double angle = 0;  ///< of its up from the face's +y, radians counter-clockwise
};

/// All of a level that is drawn and never moves.
struct StageModel {
  static constexpr double kRibbonWidth = 4;  ///< level units
  static constexpr double kGoalRadius = 16;
  static constexpr double kPlayerRadius = double{1} * platon::kPlayerRadius / kSubunitsPerUnit;

  SolidMesh mesh;
  std::vector<FaceDrawing> faces;
  Marker goal;
  Marker start;
  std::string title;
};

/// `marker` in the frame of `face`, laid flat, when that is its face or a neighbour to whose edge it is nearer than
/// `reach`.
std::optional<Marker> markerOn(const SolidMesh& mesh, int face, const Marker& marker, double reach);

std::shared_ptr<const StageModel> makeStageModel(const Level& level);

}  // namespace platon
