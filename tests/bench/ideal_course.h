#pragma once

#include <cstdint>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/ideal_path.h"

namespace platon::bench {

/// A scene of tests/exactness/reference for the engines.
Scene toScene(const reference::ExactScene& exact);

/// The velocity of its body in every step.
Place velocityOf(const reference::ExactScene& exact);

/// Ideal positions after each of the first `ticks` ticks, computed in rationals and rounded to double.
std::vector<Place> idealTrajectory(const reference::IdealPath& path, std::int64_t ticks);

}  // namespace platon::bench
