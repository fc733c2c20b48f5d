#include "tests/bench/parts_bench.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/game/level.h"
#include "platon/game/player.h"
#include "platon/game/solid.h"
#include "platon/physics/map_part.h"
#include "tests/bench/heap.h"
#include "tests/sim/seeded_random.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 41;
constexpr std::int32_t kFace = 480;  // level units
constexpr std::int32_t kHalf = kFace / 2 * kSubunitsPerUnit;
constexpr std::int64_t kStepsPerMove = 16;
constexpr int kWarmMoves = 100;  // 1 600 of the 36 000 angles
constexpr std::int32_t kSpeed = kPlayerRadius / static_cast<std::int32_t>(kStepsPerMove);

class Piercing : public Rules {
 public:
  bool pierce(const Entity&, const SegmentRef& segment) const override { return segment.warp; }
};

// A body that moves back and forth by its radius.
class Oscillation {
 public:
  Oscillation(World world, Rules* rules, std::int32_t turn, Point velocity)
      : world_(std::move(world)), turn_(turn), velocity_(velocity) {
    if (rules != nullptr) world_.setRules(*rules);
  }

  PartResult result(const std::string& scene) const {
    const auto moves = static_cast<double>(steps_ / kStepsPerMove);
    return {scene,
            1 + static_cast<double>(furtherInstances_) / moves,
            static_cast<double>(world_.entities()[0].crossings) / static_cast<double>(steps_),
            static_cast<double>(allocations_) / static_cast<double>(lastSteps_),
            {}};
  }
  // Nanoseconds per step.
  double run(std::int64_t steps) {
    const std::int64_t end = steps_ + steps;
    const std::size_t before = allocations();
    const double spent = nanosecondsOf([&] {
      while (steps_ < end) {
        moveOnce();
        furtherInstances_ += world_.instancesOf(0).size();
      }
    });
    allocations_ = allocations() - before;
    lastSteps_ = steps;
    return spent / static_cast<double>(steps);
  }
  // Forgets all rotated shapes. The next steps are a warm-up.
  void forgetAngles() {
    World world = world_;
    world_ = std::move(world);
    for (int i = 0; i < kWarmMoves; ++i) moveOnce();
  }

 private:
  void moveOnce() {
    const std::int32_t sign = steps_ / kStepsPerMove % 2 == 0 ? 1 : -1;
    for (std::int64_t i = 0; i < kStepsPerMove; ++i, ++steps_) {
      Entity entity(world_, 0);
      entity.setVelocity({sign * velocity_.x, sign * velocity_.y}, entity.rotation());
      if (turn_ != 0) entity.rotate(turn_);
      world_.solve();
    }
  }

  World world_;
  std::int32_t turn_;
  Point velocity_;
  std::int64_t steps_ = 0;
  std::size_t furtherInstances_ = 0;
  // Of the last pass.
  std::int64_t lastSteps_ = 1;
  std::size_t allocations_ = 0;
};

// The segments of the plane and of each face of the cube, away from its centre and edges; level units.
std::vector<Segment> someLines() {
  sim::SeededRandom random(kSeed);
  std::vector<Segment> lines;
  while (lines.size() < 40) {
    const Point a = random.vector(kFace * 3 / 8);
    if (squaredLength(a) < squaredLength(Point(kFace / 6, 0))) continue;
    lines.push_back({a, a + random.vector(kFace / 24)});
  }
  return lines;
}

World plane() {
  World world;
  MapPart part(world, 0);
  const auto subunits = [](Point point) { return Point(point.x * kSubunitsPerUnit, point.y * kSubunitsPerUnit); };
  for (const Segment& line : someLines()) part.line(subunits(line.a), subunits(line.b));
  part.initialize();
  return world;
}

World cube() {
  std::string face = "%\n";
  for (const auto& [a, b] : someLines()) {
    for (const std::int32_t number : {a.x, a.y, b.x, b.y}) face += std::to_string(number) + " ";
    face += "\n";
  }
  std::string text = "HEXAHEDRON\n0 0 0 0\n5 0 0\n" + std::to_string(kFace) + "\n";
  for (int i = 0; i < 6; ++i) text += face;
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error(format("cube", result.diagnostics.at(0)));
  return result.level->world;
}

World with(World world, Point position) {
  Entity entity(world, playerShape());
  MapPart(world, 0).insert(entity, position, Angle());
  return world;
}

}  // namespace

std::vector<PartResult> benchParts(const Effort& effort) {
  constexpr Point kOnEdge{kHalf - 6 * kSubunitsPerUnit, 0};
  constexpr Point kEdge{kHalf - 2 * kSubunitsPerUnit, 0};
  constexpr Point kCorner{kHalf - 10 * kSubunitsPerUnit, kHalf - 10 * kSubunitsPerUnit};
  static Piercing piercing;
  struct Scene {
    std::string name;
    std::unique_ptr<Oscillation> oscillation;
  };
  std::vector<Scene> scenes;
  const auto add = [&](const std::string& name, World world, Rules* rules, std::int32_t turn,
                       Point velocity = {kSpeed, 0}) {
    scenes.push_back({name, std::make_unique<Oscillation>(std::move(world), rules, turn, velocity)});
  };
  constexpr Point kSlow{kSpeed / 64, 0};
  add("plane, at rest", with(plane(), {}), nullptr, 0, {});
  add("plane", with(plane(), {}), nullptr, 0);
  add("plane, own rules", with(plane(), {}), &piercing, 0);
  add("plane, rotating by 5°", with(plane(), {}), nullptr, 500);
  add("plane, rotating by 4.99°, new angles", with(plane(), {}), nullptr, 499);
  add("solid, middle of a face", with(cube(), {}), nullptr, 0);
  add("solid, over an edge back and forth", with(cube(), kEdge), nullptr, 0);
  add("solid, along an edge back and forth", with(cube(), kOnEdge), nullptr, 0, {0, kSpeed});
  add("solid, at a corner", with(cube(), kCorner), nullptr, 0, kSlow);
  add("solid, at a corner, rotating by 5°", with(cube(), kCorner), nullptr, 500, kSlow);
  add("solid, at a corner, rotating by 4.99°, new angles", with(cube(), kCorner), nullptr, 499, kSlow);
  const std::int64_t steps = std::max(kStepsPerMove, 20000 / effort.divisor / kStepsPerMove * kStepsPerMove);
  std::vector<std::function<double()>> passes;
  for (const Scene& scene : scenes) {
    passes.push_back([oscillation = scene.oscillation.get(), steps, isNew = scene.name.ends_with("new angles")] {
      if (isNew) oscillation->forgetAngles();
      return oscillation->run(steps);
    });
  }
  const auto spreads = interleaved(passes, effort.passes);
  std::vector<PartResult> results;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    results.push_back(scenes[i].oscillation->result(scenes[i].name));
    results.back().nsPerStep = spreads[i];
  }
  return results;
}

}  // namespace platon::bench
