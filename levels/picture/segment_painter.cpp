#include "levels/picture/segment_painter.h"

#include <algorithm>
#include <cstddef>

namespace platon {
namespace {

// The time of a stroke grows faster than the number of its lines.
constexpr std::size_t kLinesPerStroke = 256;

}  // namespace

void paintSegments(Canvas& canvas, std::span<const LevelDrawing::Line> lines, Colour ink, double width) {
  while (!lines.empty()) {
    const auto part = lines.first(std::min(lines.size(), kLinesPerStroke));
    for (const LevelDrawing::Line& line : part) canvas.line(line.a, line.b);
    canvas.stroke({ink}, width);
    lines = lines.subspan(part.size());
  }
}

}  // namespace platon
