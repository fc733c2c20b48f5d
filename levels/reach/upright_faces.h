#pragma once

#include <cstdint>
#include <vector>

#include "levels/reach/vec.h"
#include "platon/game/level.h"
#include "platon/game/solid.h"

namespace platon {

/// A face as a player with one up sees it: turned so that up is +y. Over an edge such frames differ by a shift alone.
struct UprightFace {
  /// The neighbour over an edge.
  struct Neighbour {
    std::uint32_t node = 0;  ///< index into UprightFaces::all()
    Vec shift;               ///< added to a point in this frame, gives the point in that of the neighbour
  };

  std::uint32_t face = 0;
  Angle up;                           ///< from the face's +y
  std::vector<Vec> polygon;           ///< level units; edge i runs from corner i to corner i + 1
  std::vector<Neighbour> neighbours;  ///< by edge
};

/// All faces with all ups that a player can have on them.
class UprightFaces {
 public:
  explicit UprightFaces(const Level& level);

  const std::vector<UprightFace>& all() const { return all_; }
  /// The index of a face with this up; all().size() when no player can have it.
  std::uint32_t find(std::uint32_t face, Angle up) const;

 private:
  std::uint32_t add(std::uint32_t face, Angle up, const std::vector<Point>& polygon);

  std::vector<UprightFace> all_;
};

}  // namespace platon
