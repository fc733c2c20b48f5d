#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/exactness/reference/exact_scene.h"

namespace platon::reference {

/// Scene files are in sixteenths of a level unit: the coarsest resolution that is measured.
inline constexpr std::int64_t kSceneSubunits = 16;

/// How far the world's mover is from the ideal one.
struct LatticeError {
  std::string scene;
  std::int64_t subunitsPerUnit = 0;
  std::int64_t ticks = 0;
  std::int64_t legs = 0;    ///< moves of the world's mover up to here
  double subunits = 0;      ///< distance at this tick
  double mostSubunits = 0;  ///< the longest one up to here

  double units() const { return subunits / static_cast<double>(subunitsPerUnit); }
};

/// Runs a scene in the world at each resolution (a multiple of kSceneSubunits) and once exactly; reports after each of
/// `ticks`, which ascend.
std::vector<LatticeError> latticeErrors(const std::string& name, const ExactScene& scene,
                                        std::span<const std::int64_t> resolutions, std::span<const std::int64_t> ticks);

/// The scenes of tests/exactness/reference/scenes, by name. Run from the root of the tree.
std::vector<std::pair<std::string, ExactScene>> allScenes();

}  // namespace platon::reference
