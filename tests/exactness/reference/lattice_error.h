#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/exactness/reference/exact_scene.h"

namespace platon::reference {

/// Subunits per level unit in scene files: the coarsest resolution that is measured.
inline constexpr std::int64_t kSceneSubunits = 16;

/// Distance of the simulated body from the ideal one.
struct LatticeError {
  std::string scene;
  std::int64_t subunitsPerUnit = 0;
  std::int64_t ticks = 0;
  std::int64_t legs = 0;   ///< legs of the simulated body up to this tick
  double subunits = 0;     ///< distance at this tick
  double maxSubunits = 0;  ///< largest distance up to this tick

  double units() const { return subunits / static_cast<double>(subunitsPerUnit); }
};

/// Runs a scene in the simulation at each resolution, a multiple of kSceneSubunits, and once exactly. Returns the
/// errors after each of `ticks`, which must ascend.
std::vector<LatticeError> latticeErrors(const std::string& name, const ExactScene& scene,
                                        std::span<const std::int64_t> resolutions, std::span<const std::int64_t> ticks);

/// The scenes of tests/exactness/reference/scenes with their names, sorted by name. Requires the root of the tree as
/// working folder.
std::vector<std::pair<std::string, ExactScene>> allScenes();

/// The same scenes in subunits at 1024 per unit, and at a tenth of the speed: the body stays on its segments for 36 000
/// ticks.
std::vector<std::pair<std::string, ExactScene>> allSlowScenes();

}  // namespace platon::reference
