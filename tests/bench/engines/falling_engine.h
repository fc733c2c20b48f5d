#pragma once

#include <memory>

#include "tests/bench/engines/engine.h"

namespace platon::bench {

/// Adds the gravity of the scene to an engine without gravity, as a game does: a body falls faster by `gravity` in
/// every step, and its vertical velocity is 0 after a step in which something stopped it. Returns `engine` itself if
/// the scene has no gravity.
std::unique_ptr<Engine> withGravity(std::unique_ptr<Engine> engine, const Scene& scene);

}  // namespace platon::bench
