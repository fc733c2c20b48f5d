#include "tests/bench/resolution_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/bench/ideal_course.h"
#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/lattice_error.h"

namespace platon::bench {
namespace {

constexpr int kTicks = 100;
constexpr std::int64_t kFinest = std::int64_t{1} << 16;

using reference::ExactScene;
using reference::kSceneSubunits;

struct Course {
  ExactScene scene;
  std::vector<Place> trajectory;  // in sixteenths of a unit
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
      const Place velocity = velocityOf(fine);
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
  for (auto& [name, scene] : reference::allScenes()) {
    courses.push_back({scene, idealTrajectory(reference::IdealPath(scene, kTicks), kTicks)});
  }
  std::vector<std::unique_ptr<Runs>> runs;
  std::vector<std::function<double()>> passes;
  std::vector<ResolutionResult> results;
  // The other engines discard the rest of a step at a contact: 100 ticks of theirs show nothing else.
  static const std::vector<EngineKind> kinds{{"platon", &makePlaton},
                                             {kIdealPlace, &makePlatonIdealPlace},
                                             {"float32", &makeFloat32},
                                             {"float64", &makeFloat64}};
  for (const EngineKind& kind : kinds) {
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
