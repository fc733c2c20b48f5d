#pragma once

#include <glm/vec2.hpp>

#include "levels/drawing/colour.h"
#include "levels/picture/canvas.h"
#include "platon/game/element.h"
#include "platon/game/solid.h"

namespace platon {

/// The colours of a picture: each solid has soft tints of its own.
class Tints {
 public:
  explicit Tints(SolidKind kind);

  /// Of the page.
  Colour background() const;
  /// Of segments and text.
  Colour ink() const;
  /// A face on which so much light falls, 0 … 1. Always lighter than the ink.
  Colour face(double brightness) const;

  /// The same for all solids.
  static Colour start();
  static Colour goal();
  static Colour up();
  static Colour hazard();
  static Colour checkpoint();
  /// Of keys and doors.
  static Colour lock();
  static Colour plate();
  static Colour timed();

 private:
  double hue_;  // degrees
};

// Marks of a level. Lengths are in the units of the canvas's map, directions are unit vectors.

void paintArrow(Canvas& canvas, glm::dvec2 tail, glm::dvec2 head, const Ink& ink, double width);

/// A ball with a mark towards its up.
void paintBall(Canvas& canvas, glm::dvec2 place, glm::dvec2 up, double radius, const Tints& tints);

/// A ring round a dot. `radius` is that of the outer side of the ring.
void paintGoal(Canvas& canvas, glm::dvec2 place, double radius, const Tints& tints);

/// What is drawn of an element.
struct ElementStyle {
  ElementKind kind = ElementKind::kOneway;
  int number = 0;            ///< of a key, a door or a plate
  glm::dvec2 towards{0, 1};  ///< of kUp: unit, to the edge to which the up of a blocked player points
};

/// Draws elements, the segments that are more than walls. Each kind has a pattern, and most have a glyph, so that they
/// differ without colour as well:
///   oneway      chevrons on the right side, from which it lets pass, point through the thin line
///   up          arrows point to its edge
///   hazard      a zigzag
///   checkpoint  dashes and a flag
///   key         dots, and a key with its number
///   door        two lines, and its number
///   plate       a line with a bar on its left side, and its number
///   timed       a row of bars, and a clock
class ElementPainter {
 public:
  /// `width` is that of a wall, in the units of the canvas's map, whose +y points up. `canvas` and `tints` must outlive
  /// the painter.
  ElementPainter(Canvas& canvas, const Tints& tints, double width) : canvas_(&canvas), tints_(&tints), width_(width) {}

  void paint(glm::dvec2 a, glm::dvec2 b, const ElementStyle& style);

 private:
  // A segment with its frame: unit vectors along it and to its left.
  struct Track {
    glm::dvec2 a{0};
    glm::dvec2 b{0};
    glm::dvec2 along{1, 0};
    glm::dvec2 left{0, 1};
    double length = 0;

    glm::dvec2 at(double distance, double aside) const { return a + distance * along + aside * left; }
    glm::dvec2 middle() const { return (a + b) / 2.0; }
  };

  // Calls `draw(distance from a)` at places that divide the track evenly, about `gap` apart.
  template <typename Draw>
  void repeat(const Track& track, double gap, Draw draw) const;

  void paintOneWay(const Track& track);
  void paintUp(const Track& track, glm::dvec2 towards);
  void paintHazard(const Track& track);
  void paintCheckpoint(const Track& track);
  void paintKey(const Track& track, int number);
  /// A key with its teeth at the right. `bow` is the middle of its ring.
  void strokeKey(glm::dvec2 bow, const Ink& ink, double thickness);
  void paintDoor(const Track& track, int number);
  void paintPlate(const Track& track, int number);
  void paintTimed(const Track& track);
  void paintNumber(glm::dvec2 middle, int number, Colour colour);

  Canvas* canvas_;
  const Tints* tints_;
  double width_;
};

}  // namespace platon
