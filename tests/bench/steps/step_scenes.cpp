#include "tests/bench/steps/step_scenes.h"

#include <algorithm>
#include <cmath>

#include "platon/exact/integer.h"
#include "platon/physics/sweep.h"
#include "tests/shared/physics/shapes.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 8;
constexpr std::int32_t kRadius = 12 * kSubunitsPerUnit;
constexpr std::int32_t kSpeed = kRadius / 2;  // 22 m/s
constexpr std::int32_t kLongestLine = 6 * kRadius;
constexpr std::int32_t kSpacing = 6 * kRadius;  // side of the square that holds one segment on average

constexpr std::int32_t kTile = static_cast<std::int32_t>(kSubunitsPerMetre);
constexpr std::int32_t kStorey = 4 * kTile;
constexpr double kGravity = 80;      // 17.6 m/s^2
constexpr double kWalkSpeed = 1638;  // 6 m/s
constexpr double kJumpSpeed = 2184;  // 8 m/s: 1.8 m high
constexpr std::size_t kBodiesPerStanding = 3;

bool isFree(const Convex& shape, Point position, const std::vector<Segment>& lines) {
  Sweep sweep;
  sweep.start(shape, position, {});
  return std::none_of(lines.begin(), lines.end(), [&](const Segment& line) { return sweep.against(line).has_value(); });
}

// `segments` segments, evenly distributed over a square that grows with their number, and four walls around it.
Scene randomScene(std::size_t segments, std::size_t bodies) {
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

// A storey from x = 0 to the other wall: tiles, some of them raised, and the steps between them. Stops at `segments`.
void addStorey(std::int32_t height, std::int32_t width, std::size_t segments, sim::SeededRandom& random,
               std::vector<Segment>& lines) {
  std::int32_t raised = 0;
  for (std::int32_t x = 0; x < width && lines.size() < segments; x += kTile) {
    const std::int32_t last = raised;
    if (random.below(8) == 0) raised = kTile - raised;
    if (raised != last) lines.push_back({{x, height}, {x, height + kTile}});
    if (lines.size() < segments) lines.push_back({{x, height + raised}, {x + kTile, height + raised}});
  }
}

// Storeys from below upwards; the last one may be shorter. Bodies start in the air above a storey.
Scene platformerScene(std::size_t segments, std::size_t bodies) {
  sim::SeededRandom random(kSeed);
  const auto tiles = static_cast<std::int32_t>(std::sqrt(static_cast<double>(2 * segments)));
  const std::int32_t width = tiles * kTile;
  Scene scene{.segments = {}, .shape = regular(8, kRadius), .bodies = {}, .gravity = kGravity};
  scene.segments.resize(2);
  std::int32_t top = 0;
  for (; scene.segments.size() < segments; top += kStorey) addStorey(top, width, segments, random, scene.segments);
  const std::int32_t roof = top + kStorey;
  scene.segments[0] = {{0, roof}, {0, 0}};
  scene.segments[1] = {{width, 0}, {width, roof}};
  while (scene.bodies.size() < bodies) {
    const auto x = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(width)));
    const auto storey = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(top / kStorey)));
    const Point position(x, storey * kStorey + kTile + kRadius + kTile / 4);
    if (isFree(scene.shape, position, scene.segments)) scene.bodies.push_back(position);
  }
  return scene;
}

Place randomVelocity(std::size_t, sim::SeededRandom& random) {
  const Point velocity = random.vector(kSpeed);
  return {static_cast<double>(velocity.x), static_cast<double>(velocity.y)};
}

Place walkingVelocity(std::size_t body, sim::SeededRandom& random) {
  if (body % kBodiesPerStanding == 0) return {};
  const bool jumps = random.below(2) == 0;
  return {random.below(2) == 0 ? kWalkSpeed : -kWalkSpeed, jumps ? kJumpSpeed : 0};
}

}  // namespace

const StepScenes& randomScenes() {
  static const StepScenes scenes{"random", &randomScene, &randomVelocity};
  return scenes;
}

const StepScenes& platformerScenes() {
  static const StepScenes scenes{"platformer", &platformerScene, &walkingVelocity};
  return scenes;
}

}  // namespace platon::bench
