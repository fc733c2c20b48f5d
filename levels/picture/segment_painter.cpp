#include "levels/picture/segment_painter.h"

#include <cstddef>

#include "levels/picture/element_painter.h"

namespace platon {
namespace {

// The time of a stroke grows faster than the number of its lines.
constexpr std::size_t kLinesPerStroke = 256;

}  // namespace

void paintSegments(Canvas& canvas, std::span<const LevelDrawing::Line> lines, const Tints& tints, double width) {
  ElementPainter elements(canvas, tints, width);
  std::size_t walls = 0;
  for (const LevelDrawing::Line& line : lines) {
    if (line.element) continue;
    canvas.line(line.a, line.b);
    if (++walls % kLinesPerStroke == 0) canvas.stroke({tints.ink()}, width);
  }
  canvas.stroke({tints.ink()}, width);
  for (const LevelDrawing::Line& line : lines) {
    if (line.element) elements.paint(line.a, line.b, *line.element);
  }
}

}  // namespace platon
