#include "levels/check/level_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <tuple>

#include "levels/reach/jump_heights.h"
#include "levels/reach/vec.h"
#include "platon/game/game.h"
#include "platon/game/player.h"

namespace platon {
namespace {

constexpr int kTicksToLand = 10 * kTicksPerSecond;
constexpr double kGoalClearance = 0.5;  // level units, so that nobody touches the goal through a wall

Vec unitsOf(Point point) { return uprightOf(point, Angle()); }

void warnOfEndlessFall(const std::shared_ptr<const Level>& level, Diagnostics& diagnostics) {
  Game game(level);
  const Input still[] = {Input{Input::kPresent}};
  for (int tick = 0; tick < kTicksToLand; ++tick) {
    game.advance(still);
    const PlayerState& player = game.player(0);
    if (player.ground != Point() || player.arrived != 0) return;
  }
  diagnostics.warning(level->startAt, "the player falls for ever from the start: put a line below it");
}

void warnOfGoalAtWall(const Level& level, Diagnostics& diagnostics) {
  constexpr double radius = double{1} * kGoalRadius / kSubunitsPerUnit;
  for (const Place& goal : level.goalPlaces) {
    for (std::size_t i = 0; i < level.segments[goal.part].size(); ++i) {
      const Segment& segment = level.segments[goal.part][i];
      const double apart = distance(unitsOf(goal.position), Line{unitsOf(segment.a), unitsOf(segment.b)});
      const Element* const element = findElement(level.elements, goal.part, static_cast<std::uint32_t>(i));
      if (apart >= radius + kGoalClearance || (element != nullptr && !canBlock(element->kind))) continue;
      diagnostics.warning(level.goalAt, "the goal's disc, of radius 16, is too close to line " +
                                            std::to_string(level.positions[goal.part][i].line) +
                                            ": move it away, or players may touch it through the line");
      return;
    }
  }
}

// Of the doors of a number, the first one of the text is named.
void warnOfShutDoors(const Level& level, Diagnostics& diagnostics) {
  std::map<std::uint16_t, TextPosition> doors;
  for (const Element& element : level.elements) {
    if (!isDoor(element.kind) || (level.doorNumbers & element.bit()) != 0) continue;
    const TextPosition at = level.positions[element.face][element.segment];
    const auto [first, isNew] = doors.try_emplace(element.number, at);
    if (!isNew && at.line < first->second.line) first->second = at;
  }
  for (const auto& [number, at] : doors) {
    const std::string text = std::to_string(number);
    diagnostics.warning(
        at, "door " + text + " never opens: draw a key " + text + " or a plate " + text + ", or make it a wall");
  }
}

void warnOfMissingNeeds(const Level& level, Diagnostics& diagnostics) {
  for (const ElementWord need : level.needs) {
    const auto isMeant = [&](const Element& element) { return need.isOf(element); };
    if (std::any_of(level.elements.begin(), level.elements.end(), isMeant)) continue;
    diagnostics.warning(level.needsAt,
                        "'needs:' names " + need.text() + ", which the level lacks: draw it, or do not name it");
  }
}

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

// Levels with more lines or larger faces are not made by hand, and are not searched.
constexpr std::size_t kMaxLinesOfALevel = 3000;
constexpr std::int32_t kLargestFace = 2000;

bool isSearched(const Level& level) { return lineCount(level) <= kMaxLinesOfALevel && level.faceSize <= kLargestFace; }

}  // namespace

void warnOfNarrowGaps(const Level& level, Diagnostics& diagnostics) {
  for (std::size_t face = 0; face < level.segments.size(); ++face) {
    if (level.segments[face].size() <= kMaxLinesOfAFace) NarrowGaps(level, face).warn(diagnostics);
  }
}

std::size_t lineCount(const Level& level) {
  std::size_t lines = 0;
  for (const auto& face : level.segments) lines += face.size();
  return lines;
}

void warnOfUntouchedGoal(const Level& level, Diagnostics& diagnostics, const std::function<bool()>& stop) {
  if (!isSearched(level)) return;
  const JumpHeights heights(level, {.stop = stop});
  if (!heights.isStopped() && !heights.reachesGoal())
    diagnostics.warning(level.goalAt, "nobody can touch the goal, whatever is pressed: open a way to it");
}

void warnOfUntouchedLines(const Level& level, Diagnostics& diagnostics, const std::function<bool()>& stop) {
  if (!isSearched(level)) return;
  const JumpHeights heights(level, {.allDoorsOpen = true, .stop = stop});
  if (heights.isStopped()) return;
  for (std::uint32_t face = 0; face < level.segments.size(); ++face) {
    for (std::size_t i = 0; i < level.segments[face].size(); ++i) {
      if (heights.touches(face, level.segments[face][i])) continue;
      diagnostics.warning(level.positions[face][i], "nobody can touch this line: remove it, or open a way to it");
    }
  }
}

std::vector<Diagnostic> warningsOf(const std::shared_ptr<const Level>& level, const std::function<bool()>& stop) {
  Diagnostics diagnostics;
  warnOfEndlessFall(level, diagnostics);
  warnOfGoalAtWall(*level, diagnostics);
  warnOfShutDoors(*level, diagnostics);
  warnOfMissingNeeds(*level, diagnostics);
  warnOfNarrowGaps(*level, diagnostics);
  warnOfUntouchedGoal(*level, diagnostics, stop);
  warnOfUntouchedLines(*level, diagnostics, stop);
  return diagnostics.take();
}

}  // namespace platon
