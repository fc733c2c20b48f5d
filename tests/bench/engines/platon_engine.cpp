#include "tests/bench/engines/platon_engine.h"

#include <cstdint>
#include <memory>
#include <vector>

#include "platon/exact/precise_point.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "tests/bench/engines/falling_engine.h"

namespace platon::bench {
namespace {

constexpr std::uint32_t kPart = 0;

class ComputedEngine : public PlatonEngine {
 public:
  using PlatonEngine::PlatonEngine;

  void setVelocity(std::size_t body, Place velocity) override {
    PlatonEngine::setVelocity(body, {velocity.x, velocity.y - change_});
  }
  void step() override {
    PlatonEngine::step();
    change_ = 1 - change_;
  }

 private:
  double change_ = 0;  // subunits
};

class IdealPlaceEngine : public PlatonEngine {
 public:
  using PlatonEngine::PlatonEngine;

  Place position(std::size_t body) const override {
    const Place lattice = PlatonEngine::position(body);
    const Point remainder = world().entities()[body].remainder;
    const auto subunits = [](std::int32_t fine) { return static_cast<double>(fine) / PrecisePoint::kOne; };
    return {lattice.x + subunits(remainder.x), lattice.y + subunits(remainder.y)};
  }
};

}  // namespace

PlatonEngine::PlatonEngine(const Scene& scene) {
  MapPart part(world_, kPart);
  for (const Segment& line : scene.segments) part.line(line.a, line.b);
  part.initialize();
  for (const Point body : scene.bodies) {
    Entity entity(world_, scene.shape);
    part.insert(entity, body, Angle());
  }
}

void PlatonEngine::setVelocity(std::size_t body, Place velocity) {
  Entity(world_, static_cast<std::uint32_t>(body))
      .setVelocity({static_cast<std::int32_t>(velocity.x), static_cast<std::int32_t>(velocity.y)});
}

void PlatonEngine::step() { world_.solve(); }

Place PlatonEngine::position(std::size_t body) const {
  const Point position = world_.entities()[body].position;
  return {static_cast<double>(position.x), static_cast<double>(position.y)};
}

std::unique_ptr<Engine> makePlaton(const Scene& scene) {
  return withGravity(std::make_unique<PlatonEngine>(scene), scene);
}
std::unique_ptr<Engine> makePlatonComputed(const Scene& scene) {
  return withGravity(std::make_unique<ComputedEngine>(scene), scene);
}
std::unique_ptr<Engine> makePlatonIdealPlace(const Scene& scene) {
  return withGravity(std::make_unique<IdealPlaceEngine>(scene), scene);
}

const std::vector<EngineKind>& engineKinds() {
  static const std::vector<EngineKind> kinds{{"platon", &makePlaton},
                                             {"float32", &makeFloat32},
                                             {"float64", &makeFloat64},
                                             {"box2d-2.4", &makeBox2d},
                                             {"chipmunk-7.0", &makeChipmunk}};
  return kinds;
}

}  // namespace platon::bench
