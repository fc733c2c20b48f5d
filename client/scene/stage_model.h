#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "client/scene/palette.h"
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

/// A stroke on a face that belongs to no level, such as a segment while it is drawn. With equal ends, a dot.
struct FaceMark {
  int face = 0;
  glm::vec2 a{0};  ///< level units in the frame of the face
  glm::vec2 b{0};
  float width = 4;      ///< level units
  glm::vec4 colour{1};  ///< with opacity
};

/// Marks that are drawn together. A list is never changed, so that a painter can keep it.
using FaceMarks = std::shared_ptr<const std::vector<FaceMark>>;

/// A small sign by which players tell faces apart: a ring with a number of corners, and dots in it.
struct FaceSign {
  glm::vec2 place{0};  ///< level units in the frame of the face
  float radius = 1;    ///< level units
  int corners = 3;     ///< 3 … 7; the ring of 7 is drawn as a circle
  int dots = 1;        ///< 1 … 4
};

/// The signs of the faces, each one different. A sign lies in the middle or towards a corner: where it is farthest from
/// segments, start and goal.
std::vector<FaceSign> signsOf(const StageModel& stage);

}  // namespace platon
