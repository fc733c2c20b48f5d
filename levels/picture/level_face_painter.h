#pragma once

#include <span>

#include "levels/picture/canvas.h"
#include "levels/picture/element_painter.h"
#include "levels/picture/level_drawing.h"

namespace platon {

/// Draws segments: walls as lines with round ends, and above them elements in patterns of their own. `width` is
/// that of a wall, in the units of the lines.
void paintSegments(Canvas& canvas, std::span<const LevelDrawing::Line> lines, const Tints& tints, double width);

/// Draws the parts of a level on one face. Everything keeps its size in the level, but stays large enough to be seen.
class LevelFacePainter {
 public:
  /// `map` leads from the frame of the face to the canvas. `unitsPerPixel` is the length of a pixel in level units,
  /// where the face is not foreshortened. `canvas` and `drawing` must outlive this.
  LevelFacePainter(Canvas& canvas, const LevelDrawing& drawing, int face, const PlaneMap& map, double unitsPerPixel);

  /// The face itself, its number and the direction of down.
  void paintGround(const Tints& tints, double brightness);
  void paintSegments(const Tints& tints);
  /// The start and the goal, where they are on this face.
  void paintMarks(const Tints& tints);

 private:
  /// A length that is at least so many pixels.
  double visible(double units, double pixels) const;
  void paintNumber(const Tints& tints);
  void paintStart(const Tints& tints);

  Canvas* canvas_;
  const LevelDrawing* drawing_;
  int face_;
  PlaneMap map_;
  double unitsPerPixel_;
};

}  // namespace platon
