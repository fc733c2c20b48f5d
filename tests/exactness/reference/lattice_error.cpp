#include "tests/exactness/reference/lattice_error.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/step_observer.h"
#include "platon/physics/world.h"
#include "tests/exactness/reference/exact_body.h"
#include "tests/support/files.h"

namespace platon::reference {
namespace {

Point toPoint(oracle::Vec v) { return {static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)}; }

Convex toConvex(const oracle::Polygon& polygon) {
  std::vector<Point> points;
  for (const oracle::Vec v : polygon) points.push_back(toPoint(v));
  return Convex(std::move(points));
}

/// The simulated body at one resolution.
class LatticeBody : public StepObserver {
 public:
  LatticeBody(const ExactScene& scene, std::int64_t resolution)
      : resolution_(resolution), factor_(resolution / kSceneSubunits) {
    const ExactScene fine = scaled(scene, factor_);
    MapPart part(world_, 0);
    for (const oracle::Segment& line : fine.lines) part.line(toPoint(line.a), toPoint(line.b));
    part.initialize();
    Entity entity(world_, toConvex(fine.shape));
    part.insert(entity, toPoint(fine.start), Angle());
    velocity_ = toPoint(fine.velocity);
  }

  void tick(const RationalVec& ideal) {
    Entity(world_, 0).setVelocity(velocity_);
    legs_ -= 1;  // the observer is also called at the start of the step
    world_.solve(this);
    const Point at = world_.entities()[0].position;
    const mpq_class dx = at.x - ideal.x * factor_;
    const mpq_class dy = at.y - ideal.y * factor_;
    distance_ = std::hypot(dx.get_d(), dy.get_d());
    max_ = std::max(max_, distance_);
  }

  void leg(std::uint32_t, std::span<const InstanceView>) override { ++legs_; }

  LatticeError report(const std::string& scene, std::int64_t ticks) const {
    return {scene, resolution_, ticks, legs_, distance_, max_};
  }

 private:
  World world_;
  Point velocity_;
  std::int64_t resolution_;
  std::int64_t factor_;
  std::int64_t legs_ = 0;
  double distance_ = 0;
  double max_ = 0;
};

}  // namespace

std::vector<LatticeError> latticeErrors(const std::string& name, const ExactScene& scene,
                                        std::span<const std::int64_t> resolutions,
                                        std::span<const std::int64_t> ticks) {
  ExactBody ideal(scene);
  std::vector<LatticeBody> bodies;
  for (const std::int64_t resolution : resolutions) bodies.emplace_back(scene, resolution);
  std::vector<LatticeError> errors;
  for (std::int64_t tick = 1; tick <= ticks.back(); ++tick) {
    ideal.tick();
    for (LatticeBody& body : bodies) body.tick(ideal.position());
    if (!std::binary_search(ticks.begin(), ticks.end(), tick)) continue;
    for (const LatticeBody& body : bodies) errors.push_back(body.report(name, tick));
  }
  return errors;
}

std::vector<std::pair<std::string, ExactScene>> allScenes() {
  std::vector<std::pair<std::string, ExactScene>> scenes;
  for (const std::string& file : filesIn("tests/exactness/reference/scenes", ".scene")) {
    try {
      scenes.emplace_back(std::filesystem::path(file).stem().string(), readScene(readText(file)));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(file + ": " + error.what());
    }
  }
  return scenes;
}

}  // namespace platon::reference
