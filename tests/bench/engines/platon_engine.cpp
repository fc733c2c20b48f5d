#include <cstdint>
#include <memory>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "tests/bench/engines/engine.h"

namespace platon::bench {
namespace {

constexpr std::uint32_t kPart = 0;

class PlatonEngine : public Engine {
 public:
  explicit PlatonEngine(const Scene& scene) {
    MapPart part(world_, kPart);
    for (const Segment& line : scene.segments) part.line(line.a, line.b);
    part.initialize();
    for (const Point body : scene.bodies) {
      Entity entity(world_, scene.shape);
      part.insert(entity, body, Angle());
    }
  }

  void setVelocity(std::size_t body, Place velocity) override {
    Entity(world_, static_cast<std::uint32_t>(body))
        .setVelocity({static_cast<std::int32_t>(velocity.x), static_cast<std::int32_t>(velocity.y)});
  }
  void step() override { world_.solve(); }
  Place position(std::size_t body) const override {
    const Point position = world_.entities()[body].position;
    return {static_cast<double>(position.x), static_cast<double>(position.y)};
  }

 private:
  World world_;
};

}  // namespace

std::unique_ptr<Engine> makePlaton(const Scene& scene) { return std::make_unique<PlatonEngine>(scene); }

const std::vector<EngineKind>& engineKinds() {
  static const std::vector<EngineKind> kinds{{"platon", &makePlaton},
                                             {"float32", &makeFloat32},
                                             {"float64", &makeFloat64},
                                             {"box2d-2.4", &makeBox2d},
                                             {"chipmunk-7.0", &makeChipmunk}};
  return kinds;
}

}  // namespace platon::bench
