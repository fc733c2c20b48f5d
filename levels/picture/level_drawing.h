#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "levels/drawing/solid_frame.h"
#include "levels/picture/element_painter.h"
#include "platon/game/level.h"

namespace platon {

/// What a picture shows of a level, face by face: level units, in the frame of the face.
struct LevelDrawing {
  struct Line {
    glm::dvec2 a{0};
    glm::dvec2 b{0};
    std::optional<ElementStyle> element;  ///< nothing: a wall
  };
  struct Arrow {
    glm::dvec2 tail{0};
    glm::dvec2 head{0};
  };
  /// The number of the face, upright in its frame.
  struct Label {
    std::string text;
    glm::dvec2 middle{0};
    double size = 0;  ///< as of Typeface
  };
  struct Face {
    std::vector<Line> lines;    ///< its segments, and those of its neighbours that lie along an edge
    std::optional<Arrow> down;  ///< where down points after the way from the start over one edge
    Label label;                ///< in the corner that has most room
  };
  struct Ball {
    int face = 0;
    glm::dvec2 place{0};
    glm::dvec2 up{0, 1};  ///< unit
  };
  struct Goal {
    int face = 0;
    glm::dvec2 place{0};
  };

  explicit LevelDrawing(const Level& level);

  /// The kinds of its elements.
  std::set<ElementKind> kinds() const;

  SolidFrame solid;
  std::vector<Face> faces;
  Ball start;
  Goal goal;

 private:
  void addSegments(const Level& level, int face);
  void addAlongEdges(int face, const Line& line);
  ElementStyle styleOf(const Element& element) const;
  void addArrows(const Level& level);
  void addLabel(int face);
};

}  // namespace platon
