#include "levels/check/level_warnings.h"

#include <algorithm>
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

}  // namespace

std::vector<Diagnostic> warningsOf(const std::shared_ptr<const Level>& level, const std::function<bool()>& stop) {
  Diagnostics diagnostics;
  warnOfEndlessFall(level, diagnostics);
  warnOfGoalAtWall(*level, diagnostics);
  warnOfNarrowGaps(*level, diagnostics);
  warnOfUntouchedLines(*level, diagnostics, stop);
  return diagnostics.take();
}

}  // namespace platon
