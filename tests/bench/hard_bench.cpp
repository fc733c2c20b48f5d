#include "tests/bench/hard_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "tests/bench/engines/engine.h"
#include "tests/bench/overlap.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/seeded_random.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 33;
constexpr std::int64_t kSteps = 100000;
constexpr std::int32_t kRadius = 12 * kSubunitsPerUnit;
constexpr std::int32_t kMetre = static_cast<std::int32_t>(kSubunitsPerMetre);
constexpr double kPop = kSubunitsPerMetre / 200;  // 5 mm, the slop of Box2D

// One engine in one hard case.
class Trial {
 public:
  Trial(const EngineKind& kind, Scene scene, const std::string& name) : kind_(kind), scene_(std::move(scene)) {
    result_.name = name;
    result_.engine = kind.name;
    restart();
  }

  void restart() { engine_ = kind_.make(scene_); }
  void step(Place velocity) {
    engine_->setVelocity(0, velocity);
    engine_->step();
    ++result_.steps;
    result_.maxOverlap = std::max(result_.maxOverlap, -gap());
  }
  Place position() const { return engine_->position(0); }
  const Scene& scene() const { return scene_; }
  // Distance to the nearest segment; negative if the shape overlaps it.
  double gap() const {
    const Place now = position();
    long double least = std::numeric_limits<long double>::infinity();
    for (const Segment& line : scene_.segments) least = std::min(least, separationOf(scene_.shape, now.x, now.y, line));
    return static_cast<double>(least);
  }
  HardResult& result() { return result_; }

 private:
  const EngineKind& kind_;
  Scene scene_;
  std::unique_ptr<Engine> engine_;
  HardResult result_;
};

// A scene with one octagon with a radius of 0.75 m.
Scene sceneOf(std::vector<Segment> lines, Point start) {
  return {.segments = std::move(lines), .shape = regular(8, kRadius), .bodies = {start}};
}

// A triangular room, counter-clockwise, with an angle of 0.1 degrees far to the right. At `middle` it becomes too
// narrow for the body. Floating point is most accurate near 0.
Scene wedge(Point middle) {
  constexpr double kHalfAngle = 0.05 / 180 * 3.14159265358979;
  constexpr std::int32_t kBefore = 700 * kMetre;
  const Scene narrow = sceneOf({}, {});
  const auto behind = static_cast<std::int32_t>(narrow.shape.bounds().high.y / std::tan(kHalfAngle));
  const auto half = static_cast<std::int32_t>((behind + kBefore) * std::tan(kHalfAngle));
  const Point tip = middle + Point(behind, 0);
  const Point low = middle - Point(kBefore, half);
  const Point high = middle - Point(kBefore, -half);
  return sceneOf({{low, tip}, {tip, high}, {high, low}}, middle - Point(5 * kMetre, 0));
}

bool isInside(Place at, const std::vector<Segment>& walls) {
  return std::all_of(walls.begin(), walls.end(), [&](const Segment& wall) {
    const double x = wall.b.x - wall.a.x;
    const double y = wall.b.y - wall.a.y;
    return x * (at.y - wall.a.y) - y * (at.x - wall.a.x) > 0;
  });
}

// Moves for half a second into the narrow end and for a third of a second back, up to 30 degrees off the axis.
HardResult moveIntoWedge(const EngineKind& kind, const std::string& name, double metresPerSecond, std::int64_t steps,
                         Point middle = {}) {
  constexpr std::int64_t kIn = 30;
  constexpr std::int64_t kOut = 20;
  Trial trial(kind, wedge(middle), name);
  sim::SeededRandom random(kSeed);
  const auto speed = static_cast<std::int32_t>(metresPerSecond * kSubunitsPerMetre / kStepsPerSecond);
  for (std::int64_t i = 0; i < steps; ++i) {
    const auto aside = Angle(static_cast<std::int32_t>(random.below(6000)) - 3000);
    const Point velocity = rotate(Point(i % (kIn + kOut) < kIn ? speed : -speed, 0), aside);
    trial.step({static_cast<double>(velocity.x), static_cast<double>(velocity.y)});
    if (isInside(trial.position(), trial.scene().segments)) continue;
    ++trial.result().tunnelled;
    trial.restart();
  }
  return trial.result();
}

// A straight floor of segments whose ends are off by up to `limit` subunits.
Scene floorOfPieces(std::int32_t limit, std::int32_t pieces) {
  constexpr std::int32_t kPiece = 2 * kMetre;
  sim::SeededRandom random(kSeed);
  std::vector<Segment> lines;
  const auto off = [&] {
    return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(limit) + 1)) - limit;
  };
  const auto near = [&](std::int32_t x) {
    const std::int32_t y = off();
    return Point(x + off(), -kRadius + y);
  };
  for (std::int32_t i = -2; i < pieces; ++i) {
    const Point a = near(i * kPiece);
    lines.push_back({a, near((i + 1) * kPiece)});
  }
  return sceneOf(std::move(lines), {0, kRadius / 8 + 2 * limit});
}

// Moves along the floor at 10 m/s and down. Restarts at its end.
HardResult moveAlongFloor(const EngineKind& kind, const std::string& name, std::int32_t limit, std::int64_t steps) {
  constexpr std::int32_t kPieces = 50;
  constexpr std::int64_t kSettling = 60;
  constexpr double kSpeed = 10 * kSubunitsPerMetre / kStepsPerSecond;
  constexpr double kEnd = (kPieces - 4) * 2.0 * kMetre;
  Trial trial(kind, floorOfPieces(limit, kPieces), name);
  const double fallen = -2 * kRadius;
  double resting = 0;
  std::int64_t settling = 0;
  for (std::int64_t i = 0; i < steps; ++i) {
    const Place before = trial.position();
    trial.step({kSpeed, -kSpeed / 4});
    const Place after = trial.position();
    if (++settling == kSettling) resting = after.y;
    if (settling > kSettling) {
      trial.result().speedDrops += after.x - before.x < 0.99 * kSpeed;
      trial.result().pops += after.y > resting + 2 * limit + kPop;
    }
    if (after.x < kEnd && after.y > fallen) continue;
    trial.result().tunnelled += after.y <= fallen;
    trial.restart();
    settling = 0;
  }
  return trial.result();
}

// Moves down into a notch between two slopes and rests.
HardResult restInNotch(const EngineKind& kind, const std::string& name, std::int64_t steps) {
  const std::int64_t settled = std::min<std::int64_t>(1000, steps / 2);
  Trial trial(kind, sceneOf({{{-3 * kMetre, 0}, {0, -3 * kMetre}}, {{0, -3 * kMetre}, {5 * kMetre, kMetre}}}, {}),
              name);
  Place rest;
  for (std::int64_t i = 0; i < steps; ++i) {
    trial.step({0, -0.1 * kMetre});
    if (i == settled) rest = trial.position();
  }
  const Place now = trial.position();
  trial.result().restDrift = std::hypot(now.x - rest.x, now.y - rest.y);
  trial.result().restGap = trial.gap();
  return trial.result();
}

}  // namespace

std::vector<HardResult> benchHardCases(const Effort& effort) {
  const std::int64_t steps = kSteps / effort.divisor;
  std::vector<EngineKind> kinds = engineKinds();
  if (effort.guest != nullptr) kinds.push_back(*effort.guest);
  std::vector<HardResult> results;
  for (const EngineKind& kind : kinds) {
    results.push_back(moveIntoWedge(kind, "wedge-10-m/s", 10, steps));
    results.push_back(moveIntoWedge(kind, "wedge-100-m/s", 100, steps));
    results.push_back(moveIntoWedge(kind, "wedge-1000-m/s", 1000, steps));
    results.push_back(moveIntoWedge(kind, "wedge-far-100-m/s", 100, steps, {30000 * kMetre, 20000 * kMetre}));
    results.push_back(moveAlongFloor(kind, "joints-2-subunits", 2, steps));
    results.push_back(moveAlongFloor(kind, "joints-1-mm", kMetre / 1000, steps));
    results.push_back(restInNotch(kind, "rest-in-a-notch", steps));
  }
  std::stable_sort(results.begin(), results.end(),
                   [](const HardResult& a, const HardResult& b) { return a.name < b.name; });
  return results;
}

}  // namespace platon::bench
