#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/look/scheme.h"
#include "client/scene/solid_mesh.h"
#include "levels/drawing/level_marks.h"
#include "platon/game/element.h"
#include "platon/game/level.h"

namespace platon {

/// A segment of the level as it is drawn; level units in the face's frame.
struct Ribbon {
  glm::vec2 a{0};
  glm::vec2 b{0};
};

/// A segment with a word as it is drawn. Its left is that of the way from `ends.a` to `ends.b`.
struct ElementDrawing {
  Ribbon ends;
  ElementKind kind = ElementKind::kOneway;
  int number = 0;             ///< of a key, a door or a plate
  glm::vec2 towards{0, 1};    ///< of kUp: unit, to the edge to which the up of a blocked player points
  std::uint32_t element = 0;  ///< index into Level::elements
  bool own = true;            ///< of the face in whose list it is; else a neighbour's that reaches over the edge
};

/// A face with its segments and label.
struct FaceDrawing {
  Colour colour{0};
  std::string label;                       ///< its index in the level file; 6 and 9 have a dot
  std::vector<Ribbon> ribbons{};           ///< also a neighbour's ribbons that reach over the edge
  std::vector<ElementDrawing> elements{};  ///< also a neighbour's elements that reach over the edge
};

/// A place on a face.
struct Marker {
  int face = 0;
  glm::vec2 place{0};
  double angle = 0;  ///< from the face's +y to the marker's up, radians counter-clockwise
};

/// The drawn parts of a level that never move.
struct StageModel {
  // Level units.
  static constexpr double kRibbonWidth = LevelMarks::kSegmentWidth;
  static constexpr double kGoalRadius = LevelMarks::kGoalRadius;
  static constexpr double kPlayerRadius = LevelMarks::kBallRadius;

  const Scheme& scheme() const { return schemeOf(mesh.solid().kind()); }

  SolidMesh mesh;
  std::vector<FaceDrawing> faces;
  Marker goal;
  Marker start;
  std::string title;
};

/// Returns `marker` in the frame of `face` if it lies on that face, or on an unfolded neighbour within `reach` of the
/// common edge.
std::optional<Marker> markerOn(const SolidMesh& mesh, int face, const Marker& marker, double reach);

std::shared_ptr<const StageModel> makeStageModel(const Level& level);

}  // namespace platon
