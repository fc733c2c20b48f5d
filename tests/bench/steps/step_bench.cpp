#include "tests/bench/steps/step_bench.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/physics/sweep.h"
#include "tests/bench/engines/engine.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 8;
constexpr std::int32_t kRadius = 12 * kSubunitsPerUnit;
constexpr std::int32_t kSpeed = kRadius / 2;  // 22 m/s
constexpr std::int32_t kLongestLine = 6 * kRadius;
constexpr std::int32_t kSpacing = 6 * kRadius;  // side of the square that holds one segment on average
constexpr int kStepsOfOneVelocity = 30;

bool isFree(const Convex& shape, Point position, const std::vector<Segment>& lines) {
  Sweep sweep;
  sweep.start(shape, position, {});
  return std::none_of(lines.begin(), lines.end(), [&](const Segment& line) { return sweep.against(line).has_value(); });
}

// `segments` segments, evenly distributed over a square that grows with their number, and four walls around it.
Scene sceneOf(std::size_t segments, std::size_t bodies) {
  sim::SeededRandom random(kSeed);
  const auto half = static_cast<std::int32_t>(std::sqrt(static_cast<double>(segments)) * kSpacing / 2);
  const auto anywhere = [&] {
    const auto coordinate = [&] {
      return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(half))) - half;
    };
    const std::int32_t x = coordinate();
    return Point(x, coordinate());
  };
  Scene scene{.segments = {}, .shape = regular(8, kRadius), .bodies = {}};
  const std::int32_t wall = half + 2 * kLongestLine;
  scene.segments = {{{-wall, -wall}, {wall, -wall}},
                    {{wall, -wall}, {wall, wall}},
                    {{wall, wall}, {-wall, wall}},
                    {{-wall, wall}, {-wall, -wall}}};
  while (scene.segments.size() < segments) {
    const Point a = anywhere();
    scene.segments.push_back({a, a + random.vector(kLongestLine)});
  }
  while (scene.bodies.size() < bodies) {
    const Point position = anywhere();
    if (isFree(scene.shape, position, scene.segments)) scene.bodies.push_back(position);
  }
  return scene;
}

std::size_t heapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

double heapBytesOf(const EngineKind& kind, const Scene& scene) {
  const std::size_t before = heapBytes();
  const auto engine = kind.make(scene);
  return static_cast<double>(heapBytes() - before);
}

class Runner {
 public:
  Runner(const EngineKind& kind, const Scene& scene) : random_(kSeed) {
    const Scene bare{.segments = {}, .shape = scene.shape, .bodies = {}};
    const Scene still{.segments = scene.segments, .shape = scene.shape, .bodies = {}};
    kind.make(still);  // so that allocations made only once do not count
    const double withSegments = heapBytesOf(kind, still);
    bytesPerSegment_ = (withSegments - heapBytesOf(kind, bare)) / static_cast<double>(scene.segments.size());
    const std::size_t before = heapBytes();
    engine_ = kind.make(scene);
    bodies_ = scene.bodies.size();
    run(2 * kStepsOfOneVelocity);  // warm
    bytesPerBody_ = (static_cast<double>(heapBytes() - before) - withSegments) / static_cast<double>(bodies_);
  }

  double bytesPerSegment() const { return bytesPerSegment_; }
  double bytesPerBody() const { return bytesPerBody_; }

  // Nanoseconds per body and step.
  double run(std::int64_t steps) {
    const std::int64_t velocities = (steps + kStepsOfOneVelocity - 1) / kStepsOfOneVelocity;
    const double spent = nanosecondsOf([&] {
      for (std::int64_t i = 0; i < velocities; ++i) runOneVelocity();
    });
    return spent / static_cast<double>(velocities * kStepsOfOneVelocity) / static_cast<double>(bodies_);
  }

 private:
  void runOneVelocity() {
    velocities_.clear();
    for (std::size_t i = 0; i < bodies_; ++i) velocities_.push_back(random_.vector(kSpeed));
    for (int step = 0; step < kStepsOfOneVelocity; ++step) {
      for (std::size_t i = 0; i < bodies_; ++i) {
        engine_->setVelocity(i, {static_cast<double>(velocities_[i].x), static_cast<double>(velocities_[i].y)});
      }
      engine_->step();
    }
  }

  sim::SeededRandom random_;
  std::unique_ptr<Engine> engine_;
  std::size_t bodies_ = 0;
  double bytesPerSegment_ = 0;
  double bytesPerBody_ = 0;
  std::vector<Point> velocities_;
};

// All scenes with this number of bodies are measured alternately, because their costs are compared.
std::vector<StepResult> benchScenes(std::size_t bodies, const Effort& effort) {
  const std::int64_t steps =
      std::max<std::int64_t>(kStepsOfOneVelocity, 60000 / static_cast<std::int64_t>(bodies) / effort.divisor);
  std::vector<std::unique_ptr<Runner>> runners;
  std::vector<std::function<double()>> passes;
  std::vector<StepResult> results;
  for (const std::size_t segments : {100u, 1000u, 10000u, 100000u}) {
    if (segments > effort.maxSegments) break;
    const Scene scene = sceneOf(segments, bodies);
    for (const EngineKind& kind : engineKinds()) {
      Runner* const runner = runners.emplace_back(std::make_unique<Runner>(kind, scene)).get();
      passes.push_back([=] { return runner->run(steps); });
      results.push_back({kind.name, segments, bodies, {}, runner->bytesPerSegment(), runner->bytesPerBody()});
    }
  }
  const auto spreads = interleaved(passes, effort.passes);
  for (std::size_t i = 0; i < results.size(); ++i) results[i].nsPerStep = spreads[i];
  return results;
}

}  // namespace

std::vector<StepResult> benchSteps(const Effort& effort) {
  std::vector<StepResult> results;
  for (const std::size_t bodies : {1u, 64u, 1000u}) {
    for (StepResult& result : benchScenes(bodies, effort)) results.push_back(std::move(result));
  }
  std::stable_sort(results.begin(), results.end(),
                   [](const StepResult& a, const StepResult& b) { return a.segments < b.segments; });
  return results;
}

}  // namespace platon::bench
