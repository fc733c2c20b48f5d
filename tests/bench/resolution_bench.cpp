#include "tests/bench/resolution_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/lattice_error.h"

namespace platon::bench {
namespace {

constexpr int kTicks = 100;
constexpr std::int64_t kFinest = std::int64_t{1} << 16;

using reference::ExactScene;
using reference::kSceneSubunits;

Point toPoint(oracle::Vec v) { return {static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)}; }

Scene toScene(const ExactScene& exact) {
  std::vector<Point> vertices;
  for (const oracle::Vec v : exact.shape) vertices.push_back(toPoint(v));
  Scene scene{.segments = {}, .shape = Convex(std::move(vertices)), .bodies = {toPoint(exact.start)}};
  for (const oracle::Segment& line : exact.lines) scene.segments.push_back({toPoint(line.a), toPoint(line.b)});
  return scene;
}

// Ideal positions after each tick, in sixteenths of a unit.
std::vector<Place> idealTrajectory(const ExactScene& scene) {
  const reference::IdealPath path(scene, kTicks);
  std::vector<Place> trajectory;
  for (int tick = 1; tick <= kTicks; ++tick) {
    const reference::RationalVec at = path.positionAt(tick);
    trajectory.push_back({at.x.get_d(), at.y.get_d()});
  }
  return trajectory;
}

struct Course {
  ExactScene scene;
  std::vector<Place> trajectory;
};

class Runs {
 public:
  Runs(const EngineKind& kind, const std::vector<Course>& courses, std::int64_t resolution)
      : kind_(kind), courses_(courses), factor_(resolution / kSceneSubunits) {}

  // Runs every scene once and keeps the largest error. Returns nanoseconds per step.
  double run() {
    double spent = 0;
    for (const Course& course : courses_) {
      const ExactScene fine = scaled(course.scene, factor_);
      Scene scene = toScene(fine);
      scene.subunitsPerUnit = static_cast<double>(factor_ * kSceneSubunits);
      const auto engine = kind_.make(scene);
      const Place velocity{static_cast<double>(fine.velocity.x), static_cast<double>(fine.velocity.y)};
      for (const Place ideal : course.trajectory) {
        spent += nanosecondsOf([&] {
          engine->setVelocity(0, velocity);
          engine->step();
        });
        note(engine->position(0), ideal);
      }
    }
    return spent / static_cast<double>(courses_.size() * kTicks);
  }
  double maxError() const { return maxError_; }

 private:
  void note(Place at, Place ideal) {
    const auto factor = static_cast<double>(factor_);
    const double distance = std::hypot(at.x / factor - ideal.x, at.y / factor - ideal.y);
    maxError_ = std::max(maxError_, distance / static_cast<double>(kSceneSubunits));
  }

  const EngineKind& kind_;
  const std::vector<Course>& courses_;
  std::int64_t factor_;
  double maxError_ = 0;
};

}  // namespace

std::vector<ResolutionResult> benchResolutions(const Effort& effort) {
  std::vector<Course> courses;
  for (auto& [name, scene] : reference::allScenes()) courses.push_back({scene, idealTrajectory(scene)});
  std::vector<std::unique_ptr<Runs>> runs;
  std::vector<std::function<double()>> passes;
  std::vector<ResolutionResult> results;
  for (const EngineKind& kind : engineKinds()) {
    if (kind.name != "platon" && !kind.name.starts_with("float"))
      continue;  // the others move by forces, so they follow a different trajectory
    for (std::int64_t resolution = kSceneSubunits; resolution <= kFinest; resolution *= 2) {
      runs.push_back(std::make_unique<Runs>(kind, courses, resolution));
      passes.push_back([run = runs.back().get()] { return run->run(); });
      results.push_back({kind.name, resolution, {}, 0});
    }
  }
  const auto spreads = interleaved(passes, effort.passes);
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].nsPerStep = spreads[i];
    results[i].maxTrajectoryError = runs[i]->maxError();
  }
  return results;
}

}  // namespace platon::bench
