#pragma once

#include <cstdint>
#include <vector>

#include "levels/reach/upright_faces.h"
#include "levels/reach/vec.h"
#include "platon/game/level.h"

namespace platon {

/// A segment near a face, in an upright frame, as it is for a player with that up.
struct ReachWall {
  enum class Kind : std::uint8_t {
    kSolid,   ///< blocks always
    kOneway,  ///< blocks from its left
    kDoor,    ///< blocks until it is opened
    kTimed,   ///< blocks at times: a player may stand on it, and may pass it
    kTrigger  ///< never blocks: a checkpoint or a key
  };

  Line line;
  Kind kind = Kind::kSolid;
  bool carries = true;               ///< a player can stand on it: it is no hazard
  bool own = true;                   ///< blocks on the face itself: no post, and not behind an edge
  std::uint32_t doors = 0;           ///< of a door: its bit
  const Element* element = nullptr;  ///< null: a plain segment
  std::uint32_t node = 0;            ///< of its face
};

/// The segments that a player on an upright face can touch, the posts at its corners included: those of the face, and
/// those of its neighbours over one and two edges. Segments of `up K` that do not block this up are left out.
std::vector<ReachWall> wallsNear(const Level& level, const UprightFaces& faces, std::uint32_t node);

}  // namespace platon
