#pragma once

#include <string>

#include "levels/drawing/solid_frame.h"
#include "platon/game/level.h"
#include "platon/game/player.h"

namespace platon {

/// The sizes of what is drawn of a level, level units.
struct LevelMarks {
  static constexpr double kSegmentWidth = 4;
  static constexpr double kGoalRadius = double{1} * platon::kGoalRadius / kSubunitsPerUnit;
  static constexpr double kBallRadius = double{1} * kPlayerRadius / kSubunitsPerUnit;
};

/// The number of a face as it is drawn on the face, upright in the frame of the face. 6 and 9 have a dot, because each
/// looks like the other one upside down.
inline std::string faceLabel(int face) { return std::to_string(face) + (face == 6 || face == 9 ? "." : ""); }

}  // namespace platon
