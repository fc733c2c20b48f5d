#include "tests/bench/trajectory_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/bench/ideal_course.h"
#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/lattice_error.h"
#include "tests/exactness/reference/terrain.h"
#include "tests/exactness/reference/terrain_judge.h"
#include "tests/exactness/reference/tie.h"

namespace platon::bench {
namespace {

using reference::ExactScene;
using reference::IdealPath;
using reference::kContactTicks;
using reference::kTerrainSubunits;
using reference::Tie;

constexpr auto kTimes = std::to_array<std::int64_t>({60, 600, 3600, 36000});
constexpr std::int64_t kTerrains = 40;
constexpr std::int64_t kFewestTerrains = 6;
/// Error of a body whose place is not a number, or is farther away than this.
constexpr double kLost = 1e9;

std::vector<EngineKind> kindsOf(const Effort& effort) {
  std::vector<EngineKind> kinds = engineKinds();
  kinds.insert(kinds.begin() + 1, {kIdealPlace, &makePlatonIdealPlace});
  if (effort.guest != nullptr) kinds.push_back(*effort.guest);
  return kinds;
}

class Measurement {
 public:
  explicit Measurement(const Effort& effort)
      : kinds_(kindsOf(effort)),
        last_(*std::prev(std::upper_bound(kTimes.begin(), kTimes.end(), kTimes.back() / effort.divisor))),
        goal_(std::max(kFewestTerrains, kTerrains / effort.divisor)) {}

  TrajectoryResults run() {
    for (const auto& [name, scene] : reference::allScenes()) {
      const ExactScene fine = scaled(scene, kTerrainSubunits / reference::kSceneSubunits);
      const IdealPath ideal(fine, last_);
      const std::int64_t ticks = lastContact(ideal);
      if (ticks > 0 && isWithoutTie(fine, IdealPath(fine, ticks), ticks)) {
        measure(name, fine, ideal, ticks);
        ++results_.scenes;
      }
    }
    for (std::uint64_t seed = 1; results_.terrains < goal_; ++seed) runTerrain(seed);
    return std::move(results_);
  }

 private:
  void runTerrain(std::uint64_t seed) {
    const ExactScene scene = reference::randomTerrain(seed, last_).scene;
    const IdealPath ideal(scene, last_);
    if (lastContact(ideal) < last_) {
      ++results_.leftContact;
    } else if (isWithoutTie(scene, ideal, last_)) {
      measure("terrain " + std::to_string(seed), scene, ideal, last_);
      ++results_.terrains;
    }
  }

  // The last of the times that has a contact shortly before, or 0.
  std::int64_t lastContact(const IdealPath& ideal) const {
    std::int64_t ticks = 0;
    for (const std::int64_t time : kTimes) {
      if (time <= last_ && ideal.touchesBetween(std::max<std::int64_t>(0, time - kContactTicks), time)) ticks = time;
    }
    return ticks;
  }

  bool isWithoutTie(const ExactScene& scene, const IdealPath& ideal, std::int64_t ticks) {
    const Tie::Kind kind = findTie(scene, ideal, ticks).kind;
    if (kind == Tie::Kind::kNone) return true;
    ++(kind == Tie::Kind::kJoint ? results_.jointTies : results_.dividedTies);
    return false;
  }

  void measure(const std::string& name, const ExactScene& exact, const IdealPath& ideal, std::int64_t ticks) {
    const std::vector<Place> trajectory = idealTrajectory(ideal, ticks);
    Scene scene = toScene(exact);
    scene.subunitsPerUnit = static_cast<double>(kTerrainSubunits);
    for (const EngineKind& kind : kinds_) {
      if (kind.name.starts_with("box2d") && scene.shape.vertices().size() > kBox2dVertices) continue;
      follow(name, kind, scene, velocityOf(exact), trajectory);
    }
  }

  void follow(const std::string& name, const EngineKind& kind, const Scene& scene, Place velocity,
              const std::vector<Place>& trajectory) {
    const auto engine = kind.make(scene);
    double worst = 0;
    std::int64_t tick = 0;
    for (const Place ideal : trajectory) {
      engine->setVelocity(0, velocity);
      engine->step();
      const Place at = engine->position(0);
      const double distance = std::hypot(at.x - ideal.x, at.y - ideal.y) / scene.subunitsPerUnit;
      worst = std::max(worst, distance < kLost ? distance : kLost);
      if (std::binary_search(kTimes.begin(), kTimes.end(), ++tick))
        results_.errors.push_back({name, kind.name, tick, worst});
    }
  }

  std::vector<EngineKind> kinds_;
  std::int64_t last_;
  std::int64_t goal_;
  TrajectoryResults results_;
};

}  // namespace

TrajectoryResults benchTrajectories(const Effort& effort) { return Measurement(effort).run(); }

}  // namespace platon::bench
