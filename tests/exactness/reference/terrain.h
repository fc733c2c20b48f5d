#pragma once

#include <cstdint>
#include <string>

#include "tests/exactness/reference/exact_scene.h"

namespace platon::reference {

/// Subunits per level unit in terrains.
inline constexpr std::int64_t kTerrainSubunits = 1024;

/// A body that is pushed with a constant velocity over a random terrain, in subunits at kTerrainSubunits.
///
/// The terrain is a chain of runs. A run is a polyline of slopes that leads the body to the left or to the right of the
/// velocity: in the frame in which the body is pushed forwards, a floor or an overhang. At the end of a run the body
/// flies on to the next one. Half of the joints are loose: the ends of their two segments miss each other by up to 2
/// subunits along both axes. Points lie on some slopes, overhangs hang over some, and some chains end with a wall.
///
/// Only integers are computed, so a seed gives the same terrain everywhere.
struct Terrain {
  std::string shape;  ///< box, triangle, hexagon or octagon
  ExactScene scene;   ///< at least `ticks` long
};

Terrain randomTerrain(std::uint64_t seed, std::int64_t ticks);

/// The content of its scene file.
std::string toText(const ExactScene& scene);

}  // namespace platon::reference
