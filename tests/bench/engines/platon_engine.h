#pragma once

#include <cstddef>

#include "platon/physics/world.h"
#include "tests/bench/engines/engine.h"

namespace platon::bench {

/// Platon as an engine without gravity.
class PlatonEngine : public Engine {
 public:
  explicit PlatonEngine(const Scene& scene);

  void setVelocity(std::size_t body, Place velocity) override;
  void step() override;
  Place position(std::size_t body) const override;
  World& world() { return world_; }
  const World& world() const { return world_; }

 private:
  World world_;
};

}  // namespace platon::bench
