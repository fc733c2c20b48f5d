#include "tests/bench/steps/step_bench.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "tests/bench/engines/engine.h"
#include "tests/bench/heap.h"
#include "tests/bench/steps/step_runner.h"
#include "tests/bench/steps/step_scenes.h"

namespace platon::bench {
namespace {

constexpr std::size_t kPlatformerBodies = 64;
// More than fit into the caches of a processor.
constexpr std::size_t kManyBodies = 10000;
constexpr std::size_t kSegmentsOfMany = 10000;

std::vector<EngineKind> stepKinds(const Effort& effort) {
  std::vector<EngineKind> kinds = engineKinds();
  kinds.insert(kinds.begin() + 1, {kComputed, &makePlatonComputed});
  if (effort.guest != nullptr) kinds.push_back(*effort.guest);
  return kinds;
}

double heapBytesOf(const EngineKind& kind, const Scene& scene) {
  const std::size_t before = heapBytes();
  const auto engine = kind.make(scene);
  return static_cast<double>(heapBytes() - before);
}

// One engine in one scene, and the heap that it uses there.
class Row {
 public:
  Row(const StepScenes& scenes, const EngineKind& kind, std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
    const Scene bare{.segments = {}, .shape = scene_->shape, .bodies = {}, .gravity = scene_->gravity};
    Scene still = *scene_;
    still.bodies.clear();
    kind.make(still);  // so that allocations made only once do not count
    const double withSegments = heapBytesOf(kind, still);
    bytesPerSegment_ = (withSegments - heapBytesOf(kind, bare)) / static_cast<double>(scene_->segments.size());
    const std::size_t before = heapBytes();
    runner_ = std::make_unique<StepRunner>(scenes, kind.make(*scene_), *scene_);
    runner_->run(2 * kStepsOfOneVelocity);  // warm
    const double all = static_cast<double>(heapBytes() - before) - withSegments;
    bytesPerBody_ = all / static_cast<double>(scene_->bodies.size());
  }

  double bytesPerSegment() const { return bytesPerSegment_; }
  double bytesPerBody() const { return bytesPerBody_; }
  double run(std::int64_t steps) { return runner_->run(steps); }
  Jams jams() { return countJams(*runner_, *scene_); }

 private:
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<StepRunner> runner_;
  double bytesPerSegment_ = 0;
  double bytesPerBody_ = 0;
};

// All scenes with this number of bodies are measured alternately, because their costs are compared.
std::vector<StepResult> benchScenes(const StepScenes& scenes, const std::vector<std::size_t>& sizes, std::size_t bodies,
                                    const Effort& effort) {
  const std::int64_t steps =
      std::max<std::int64_t>(kStepsOfOneVelocity, 60000 / static_cast<std::int64_t>(bodies) / effort.divisor);
  std::vector<std::unique_ptr<Row>> rows;
  std::vector<std::function<double()>> passes;
  std::vector<StepResult> results;
  for (const std::size_t segments : sizes) {
    if (segments > effort.maxSegments) break;
    const auto scene = std::make_shared<const Scene>(scenes.make(segments, bodies));
    for (const EngineKind& kind : stepKinds(effort)) {
      Row* const row = rows.emplace_back(std::make_unique<Row>(scenes, kind, scene)).get();
      passes.push_back([=] { return row->run(steps); });
      results.push_back(
          {scenes.name, kind.name, segments, bodies, {}, row->bytesPerSegment(), row->bytesPerBody(), {}});
    }
  }
  const auto spreads = interleaved(passes, effort.passes);
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].nsPerStep = spreads[i];
    results[i].jams = rows[i]->jams();
  }
  return results;
}

}  // namespace

std::vector<StepResult> benchSteps(const Effort& effort) {
  const std::vector<std::size_t> sizes{100, 1000, 10000, 100000};
  std::vector<StepResult> results;
  const auto add = [&](std::vector<StepResult> more) {
    std::move(more.begin(), more.end(), std::back_inserter(results));
  };
  for (const std::size_t bodies : {1u, 64u, 1000u}) add(benchScenes(randomScenes(), sizes, bodies, effort));
  add(benchScenes(randomScenes(), {kSegmentsOfMany}, kManyBodies, effort));
  std::stable_sort(results.begin(), results.end(),
                   [](const StepResult& a, const StepResult& b) { return a.segments < b.segments; });
  add(benchScenes(platformerScenes(), sizes, kPlatformerBodies, effort));
  return results;
}

}  // namespace platon::bench
