#pragma once

#include <string_view>
#include <vector>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::reference {

/// A scene file with one entity: a convex body among segments on the plane, with the same velocity in every tick.
struct ExactScene {
  oracle::Polygon shape;  ///< strictly convex, counter-clockwise, relative to the entity's position
  std::vector<oracle::Segment> lines;
  oracle::Vec start;
  oracle::Vec velocity;  ///< per tick
};

/// Every number of a scene is below this in magnitude.
inline constexpr std::int64_t kSceneLimit = std::int64_t{1} << 20;

/// Parses a scene file. Throws std::runtime_error that names the line of the error.
ExactScene readScene(std::string_view text);

/// The same scene in units `factor` times as fine.
ExactScene scaled(const ExactScene& scene, std::int64_t factor);

}  // namespace platon::reference
