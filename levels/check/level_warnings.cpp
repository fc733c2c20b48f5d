#include "levels/check/level_warnings.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "levels/check/narrow_gaps.h"
#include "levels/check/untouched_lines.h"
#include "levels/reach/vec.h"
#include "platon/game/game.h"

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
      diagnostics.warning(level.goalAt, "the goal's disc, of radius 16, is at the line of text line " +
                                            std::to_string(level.positions[goal.part][i].line) +
                                            ": move it away, or it may be touched through the line");
      return;
    }
  }
}

// Of the doors of a number, the first one of the text is named.
void warnOfShutDoors(const Level& level, Diagnostics& diagnostics) {
  std::map<std::uint8_t, TextPosition> doors;
  for (const Element& element : level.elements) {
    if (element.kind != ElementKind::kDoor || (level.doorNumbers & element.bit()) != 0) continue;
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

}  // namespace

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
