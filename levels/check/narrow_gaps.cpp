#include "levels/check/narrow_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "levels/reach/vec.h"
#include "platon/game/player.h"

namespace platon {
namespace {

constexpr double kUnit = kSubunitsPerUnit;
constexpr double kWidestGap = (2 * kPlayerRadius + 3) / kUnit;
constexpr double kTouching = 0.01;
// Levels with more lines are not made by hand, and are not searched.
constexpr std::size_t kMaxLinesOfAFace = 3000;

struct Wall {
  Line line;
  std::size_t index;
};

Vec nearestOn(const Line& line, Vec point) {
  const Vec along = line.b - line.a;
  const double squared = dot(along, along);
  const double t = squared == 0 ? 0 : std::clamp(dot(point - line.a, along) / squared, 0.0, 1.0);
  return line.a + along * t;
}

class NarrowGaps {
 public:
  NarrowGaps(const Level& level, std::size_t face) : level_(level), face_(face) {
    for (std::size_t i = 0; i < level.segments[face].size(); ++i) {
      const Element* const element =
          findElement(level.elements, static_cast<std::uint32_t>(face), static_cast<std::uint32_t>(i));
      if (element != nullptr && !canBlock(element->kind)) continue;
      const Segment& segment = level.segments[face][i];
      walls_.push_back({{uprightOf(segment.a, Angle()), uprightOf(segment.b, Angle())}, i});
    }
  }

  void warn(Diagnostics& diagnostics) const {
    for (const Wall& wall : walls_) {
      const Wall* nearest = nullptr;
      double narrowest = kWidestGap;
      for (const Vec end : {wall.line.a, wall.line.b}) {
        for (const Wall& other : walls_) {
          const double width = length(nearestOn(other.line, end) - end);
          if (&other == &wall || width < kNarrowestGap || width >= narrowest || !isOpen(end, other)) continue;
          nearest = &other;
          narrowest = width;
        }
      }
      if (nearest != nullptr) report(wall, *nearest, narrowest, diagnostics);
    }
  }

 private:
  // Whether nothing lies between the end of a wall and the other wall.
  bool isOpen(Vec end, const Wall& other) const {
    const Vec there = nearestOn(other.line, end);
    const Vec middle = (end + there) * 0.5;
    const Rect around{middle - Vec{1, 1}, middle + Vec{1, 1}};
    return std::none_of(walls_.begin(), walls_.end(),
                        [&](const Wall& wall) { return distance(around, wall.line) < kTouching; });
  }
  void report(const Wall& wall, const Wall& other, double width, Diagnostics& diagnostics) const {
    char text[32];
    std::snprintf(text, sizeof(text), "%.2f", width);
    const auto lineOf = [&](const Wall& one) { return level_.positions[face_][one.index].line; };
    if (lineOf(wall) < lineOf(other) && hasGapTo(other, wall)) return;  // the other line is named
    diagnostics.warning(
        level_.positions[face_][wall.index],
        "the gap to line " + std::to_string(lineOf(other)) + " is " + text +
            " units wide, and the ball needs 24.01: make it wider, or narrower than 18 to show that it is "
            "closed");
  }
  // Whether the nearest gap of `wall` is that to `other`.
  bool hasGapTo(const Wall& wall, const Wall& other) const {
    for (const Vec end : {wall.line.a, wall.line.b}) {
      const double width = length(nearestOn(other.line, end) - end);
      if (width >= kNarrowestGap && width < kWidestGap && isOpen(end, other)) return true;
    }
    return false;
  }

  const Level& level_;
  std::size_t face_;
  std::vector<Wall> walls_;
};

}  // namespace

void warnOfNarrowGaps(const Level& level, Diagnostics& diagnostics) {
  for (std::size_t face = 0; face < level.segments.size(); ++face) {
    if (level.segments[face].size() <= kMaxLinesOfAFace) NarrowGaps(level, face).warn(diagnostics);
  }
}

}  // namespace platon
