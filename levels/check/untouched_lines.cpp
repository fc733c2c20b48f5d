#include "levels/check/untouched_lines.h"

#include "levels/reach/jump_heights.h"

namespace platon {
namespace {

// Levels with more lines or larger faces are not made by hand, and are not searched.
constexpr std::size_t kMaxLinesOfALevel = 3000;
constexpr std::int32_t kLargestFace = 2000;

bool isSearched(const Level& level) { return lineCount(level) <= kMaxLinesOfALevel && level.faceSize <= kLargestFace; }

}  // namespace

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

}  // namespace platon
