// Hard random scenes on the plane: every leg is checked, and symmetric scenes must move symmetrically.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/exactness/properties/plane_scene.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/support/run/repetitions.h"

namespace platon::properties::plane_laws_test {
namespace {

using oracle::RandomSource;
using step_check::toPoint;

constexpr int kTicks = 12;

// Zero, along a segment, or random, with components of up to `fastest` times the scale of the scene.
Point anyVelocity(const PlaneScene& scene, std::int64_t fastest, RandomSource& random) {
  const Segment& line = scene.lines[random.below(scene.lines.size())];
  const std::int64_t limit = fastest * scene.scale;
  switch (random.below(6)) {
    case 0:
      return {};
    case 1:
      return toPoint(random.vector(scene.scale / 8 + 1));
    case 2:
      return toPoint(random.vector(limit));
    case 3: {
      oracle::Vec along = step_check::toVec(line.b - line.a) + random.vector(1);
      while (std::abs(along.x) > limit || std::abs(along.y) > limit) along = {along.x / 2, along.y / 2};
      return toPoint(along);
    }
    default:
      return toPoint(random.vector(scene.scale));
  }
}

/// Records the position of the home instance after each leg, by entity.
class Path : public StepObserver {
 public:
  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override {
    places[entity].push_back(instances.front().position);
  }

  std::map<std::uint32_t, std::vector<Point>> places;
};

void setVelocities(World& world, const std::vector<Point>& velocities, const LatticeMap& map) {
  for (std::uint32_t i = 0; i < velocities.size(); ++i) Entity(world, i).setVelocity(map.vector(velocities[i]));
}

std::vector<Point> anyVelocities(const PlaneScene& scene, RandomSource& random, std::int64_t fastest = 8) {
  std::vector<Point> velocities;
  for (std::size_t i = 0; i < scene.entities.size(); ++i) velocities.push_back(anyVelocity(scene, fastest, random));
  return velocities;
}

/// Two worlds that must move in the same way, the second one mapped by a symmetry.
struct WorldPair {
  WorldPair(const PlaneScene& scene, const PlaneScene& other, const LatticeMap& mapping)
      : one(scene.world()), two(other.world()), map(mapping) {}

  /// Runs one tick in both. Returns true if all legs are equal.
  bool advance(const std::vector<Point>& velocities) {
    Path first;
    Path second;
    setVelocities(one, velocities, LatticeMap());
    setVelocities(two, velocities, map);
    one.solve(&first);
    two.solve(&second);
    for (auto& [entity, places] : first.places) {
      for (Point& place : places) place = map.place(place);
    }
    return first.places == second.places;
  }

  World one;
  World two;
  LatticeMap map;
};

TEST(PlaneLawsTest, InvariantsHoldInEveryLeg) {
  std::size_t legs = 0;
  forEachCase(repetitions(6000), [&](RandomSource& random) {
    const PlaneScene scene = PlaneScene::from(oracle::randomScene(random));
    World world = scene.world();
    const Convex shape(scene.shape);
    step_check::StepChecker checker({world.geometry(), shape, std::nullopt, 0});
    for (int tick = 0; tick < kTicks; ++tick) {
      setVelocities(world, anyVelocities(scene, random), LatticeMap());
      world.solve(&checker);
      ASSERT_EQ(checker.finishTick(), "") << "tick " << tick << "\n"
                                          << oracle::toText({step_check::toPolygon(scene.shape), {}, {}, 0});
      for (std::uint32_t i = 0; i < scene.entities.size(); ++i) legs += checker.moves(i);
    }
  });
  EXPECT_GE(legs, repetitions(200000u));
}

// The shift is as large as the coordinate range of the moving entities permits.
TEST(PlaneLawsTest, AShiftedSceneMovesInTheSameWay) {
  forEachCase(repetitions(10000), [](RandomSource& random) {
    const PlaneScene scene = PlaneScene::from(oracle::randomScene(random));
    const LatticeMap map{false, 0, toPoint(random.vector(scene.scale < 1 << 20 ? kCoordinateLimit / 2 : 1 << 20))};
    WorldPair pair(scene, scene.mapped(map), map);
    for (int tick = 0; tick < kTicks; ++tick)
      ASSERT_TRUE(pair.advance(anyVelocities(scene, random))) << "tick " << tick;
  });
}

TEST(PlaneLawsTest, TheDirectionOfASegmentDoesNotMatter) {
  forEachCase(repetitions(10000), [](RandomSource& random) {
    const PlaneScene scene = PlaneScene::from(oracle::randomScene(random));
    PlaneScene other = scene;
    for (Segment& line : other.lines) std::swap(line.a, line.b);
    WorldPair pair(scene, other, LatticeMap());
    for (int tick = 0; tick < kTicks; ++tick)
      ASSERT_TRUE(pair.advance(anyVelocities(scene, random))) << "tick " << tick;
  });
}

// Slow enough that no entity gets from the middle of a scene to the ends of its long segments, which are 2^27 away: it
// moves at most 12 * 2 * sqrt(2) * 2^22, plus the roundings.
constexpr std::int64_t kSlow = 2;

// Long segments in every direction except the diagonals. No entity reaches an end, so that none is nudged.
PlaneScene generalScene(RandomSource& random) {
  PlaneScene scene = PlaneScene::from(oracle::randomScene(random));
  scene.lines.clear();
  const std::int64_t radius = 6 * scene.scale;
  while (scene.lines.size() < 8) {
    const oracle::Vec through = random.vector(radius);
    const oracle::Vec along = random.vector(1000);
    if (std::abs(along.x) == std::abs(along.y)) continue;
    const std::int64_t reach = (oracle::kCoordinateLimit / 4) / std::max(std::abs(along.x), std::abs(along.y));
    scene.lines.push_back(step_check::toSegment(oracle::Segment{through - reach * along, through + reach * along}));
  }
  return scene;
}

// Replaces the entities by up to four at random free positions.
void placeEntities(PlaneScene& scene, RandomSource& random) {
  scene.entities.clear();
  for (int tries = 0; tries < 400 && scene.entities.size() < 4; ++tries) {
    PlaneScene one = scene;
    one.entities = {toPoint(random.vector(4 * scene.scale))};
    try {
      one.world();
      scene.entities.push_back(one.entities.front());
    } catch (const std::invalid_argument&) {
    }
  }
}

TEST(PlaneLawsTest, ARotatedOrMirroredSceneMovesInTheSameWay) {
  std::size_t entities = 0;
  forEachCase(repetitions(8000), [&](RandomSource& random) {
    PlaneScene scene = generalScene(random);
    placeEntities(scene, random);
    entities += scene.entities.size();
    const LatticeMap map = anyMap(random, 1 << 20);
    WorldPair pair(scene, scene.mapped(map), map);
    for (int tick = 0; tick < kTicks; ++tick) {
      ASSERT_TRUE(pair.advance(anyVelocities(scene, random, kSlow)))
          << "tick " << tick << ", mirror " << map.mirror << ", quarters " << map.quarters;
    }
  });
  EXPECT_GE(entities, repetitions(8000u));
}

// In general position no two segments are hit at the same time.
TEST(PlaneLawsTest, TheOrderOfSegmentsDoesNotMatter) {
  forEachCase(repetitions(8000), [](RandomSource& random) {
    PlaneScene scene = generalScene(random);
    placeEntities(scene, random);
    PlaneScene other = scene;
    for (std::size_t i = other.lines.size(); i > 1; --i) std::swap(other.lines[i - 1], other.lines[random.below(i)]);
    for (Segment& line : other.lines) {
      if (random.oneIn(2)) std::swap(line.a, line.b);
    }
    WorldPair pair(scene, other, LatticeMap());
    for (int tick = 0; tick < kTicks; ++tick)
      ASSERT_TRUE(pair.advance(anyVelocities(scene, random, kSlow))) << "tick " << tick;
  });
}

}  // namespace
}  // namespace platon::properties::plane_laws_test
