#include "shared/physics/collider.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "shared/exact/lattice.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/shared/physics/shapes.h"

namespace platon::collider_test {
namespace {

// A square of 20 by 20 at the origin of part 0, and a collider for it.
class ColliderTest : public testing::Test {
 protected:
  void build(const std::vector<Segment>& segments) {
    addPart(world_, 0, segments);
    Entity entity(world_, square(10));
    MapPart(world_, 0).insert(entity, {0, 0}, Angle());
    begin(entity);
  }
  void begin(const Entity& entity) {
    instances_.load(world_.geometry(), shapes_, world_.shapeOf(0), world_.entities()[0], world_.instancesOf(0));
    collider_.begin(rules_, entity, instances_, regions_, work_);
  }
  const Placement& home() const { return instances_.home(); }

  World world_;
  RecordedRules rules_;
  ShapeCache shapes_;
  Instances instances_;
  std::vector<Region> regions_;
  Region::Work work_;
  Collider collider_;
};

TEST_F(ColliderTest, FindsTheEarliestHit) {
  build({{{-100, -60}, {100, -60}}, {{-100, -30}, {100, -30}}, {{-100, 50}, {100, 50}}});
  const auto hit = collider_.first(instances_, {0, 0}, {0, -80});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->placement, 0u);
  EXPECT_EQ(hit->segment, 1u);
  EXPECT_EQ(hit->hit.time, (Fraction{1, 4}));
  EXPECT_FALSE(collider_.first(instances_, {0, 0}, {0, -20})) << "it only touches";
}

TEST_F(ColliderTest, TheLowestIndexWinsAtEqualTimes) {
  build({{{0, -30}, {100, -30}}, {{-100, -30}, {5, -30}}});
  EXPECT_EQ(collider_.first(instances_, {0, 0}, {0, -80})->segment, 0u);
}

TEST_F(ColliderTest, SkipsTheIgnoredSegment) {
  build({{{-100, -30}, {100, -30}}, {{-100, -60}, {100, -60}}});
  collider_.startLeg(instances_, {0, -80});
  std::optional<LegHit> nearest;
  collider_.firstIdeal(instances_, 0, {}, precise(Point(0, -80)), nearest);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->segment, 0u);
  std::optional<LegHit> next;
  collider_.firstIdeal(instances_, 0, {}, precise(Point(0, -80)), next, nearest->segment);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->segment, 1u);
}

// All places near the path of a leg, and beyond, for two instances that are rotated against each other.
TEST_F(ColliderTest, AMoveInALegMeetsTheSegmentsThatAnyMoveMeets) {
  constexpr std::uint64_t kSeed = 71;
  sim::SeededRandom random(kSeed);
  int blocked = 0;
  for (int round = 0; round < 300; ++round) {
    world_ = World();
    std::vector<Segment> segments;
    for (int i = 0; i < 60; ++i) {
      const Point at = random.vector(400);
      segments.push_back({at, i % 4 == 0 ? at : at + random.vector(120)});
    }
    segments.push_back({{5000, 5000}, {5000, 5100}});
    addPart(world_, 0, segments);
    addPart(world_, 1, segments);
    Entity entity(world_, square(10));
    try {
      MapPart(world_, 0).insert(entity, random.vector(300), Angle());
      MapPart(world_, 1).insert(entity, random.vector(300), Angle(3300));
    } catch (const std::invalid_argument&) {
      continue;  // no place for it
    }
    instances_.load(world_.geometry(), shapes_, world_.shapeOf(0), world_.entities()[0], world_.instancesOf(0));
    collider_.begin(rules_, entity, instances_, regions_, work_);
    const Point start = home().position;
    const Point target = start + random.vector(round % 2 == 0 ? 100 : 8);
    collider_.startLeg(instances_, target);
    std::optional<LegHit> hit;
    for (std::size_t i = 0; i < 2; ++i) {
      const PrecisePoint moved = rotated(precise(target - start), instances_.all()[i].fromHome);
      collider_.firstIdeal(instances_, i, instances_.idealOf(i, precise(start)), moved, hit);
    }
    if (round % 4 == 3) collider_.clip(home(), {{5000, 5050}, {5000, 5050}}, 60);  // refills the region
    for (const Point offset : latticeDisc<24>()) {
      const Point place = (offset.x % 2 == 0 ? target : start) + offset;
      const bool isFree = collider_.isFreeInLeg(instances_, place);
      blocked += isFree ? 0 : 1;
      ASSERT_EQ(isFree, collider_.isFree(instances_, start, place)) << "seed " << kSeed << ", round " << round;
    }
  }
  EXPECT_GT(blocked, 1000);
}

TEST_F(ColliderTest, AfterAnImmediateHitAMoveInTheLegMeetsEverySegment) {
  build({{{-100, -10}, {100, -10}}, {{15, -100}, {15, 100}}});
  class WallRules : public Rules {
   public:
    Scope scope() const override { return Scope::kContacts; }
  };
  WallRules walls;
  collider_.begin(walls, Entity(world_, 0u), instances_, regions_, work_);
  collider_.startLeg(instances_, {20, -20});
  std::optional<LegHit> hit;
  collider_.firstIdeal(instances_, 0, {}, precise(Point(20, -20)), hit);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->segment, 0u);
  EXPECT_EQ(hit->hit.time, (Fraction{0, 1}));
  EXPECT_TRUE(collider_.isFreeInLeg(instances_, {5, 0}));
  EXPECT_FALSE(collider_.isFreeInLeg(instances_, {6, 0}));
}

TEST_F(ColliderTest, RecordsPierceableSegmentsOnce) {
  build({{{-100, -30}, {100, -30}}, {{-100, 40}, {100, 40}}});
  rules_.pierceable = {{0, 0}, {0, 1}};
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(collider_.first(instances_, {0, 0}, {0, -80}));
  ASSERT_EQ(collider_.pierced().size(), 1u);
  EXPECT_TRUE(Collider::isSame(collider_.pierced()[0], collider_.refOf(home(), 0)));
}

TEST_F(ColliderTest, RecordsPierceableSegmentsAfterAnImmediateHit) {
  build({{{-100, -10}, {100, -10}}, {{-100, -30}, {100, -30}}});
  rules_.pierceable = {{0, 1}};
  EXPECT_EQ(collider_.first(instances_, {0, 0}, {0, -80})->hit.time, (Fraction{0, 1}));
  ASSERT_EQ(collider_.pierced().size(), 1u);
  EXPECT_EQ(collider_.pierced()[0].index, 1u);
}

TEST_F(ColliderTest, TouchingPathsAndPositionsAreFree) {
  build({{{-100, -10}, {100, -10}}, {{50, -100}, {50, 100}}});
  EXPECT_TRUE(collider_.isFree(instances_, {0, 0}, {40, 0}));
  EXPECT_FALSE(collider_.isFree(instances_, {0, 0}, {41, 0}));
  EXPECT_TRUE(collider_.isFree(home(), {40, 0}, {40, 0}));
  EXPECT_FALSE(collider_.isFree(home(), {41, 0}, {41, 0}));
  EXPECT_FALSE(collider_.isFree(home(), {0, -1}, {0, -1}));
}

TEST_F(ColliderTest, FindsOverlappedSegments) {
  build({{{12, -100}, {12, 100}}, {{11, -100}, {11, 100}}, {{0, 13}, {0, 13}}});
  EXPECT_EQ(collider_.overlapped(home(), square(10)), std::nullopt);
  EXPECT_EQ(collider_.overlapped(home(), square(12)), 1u);
  EXPECT_EQ(collider_.overlapped(home(), square(20)), 0u);
  rules_.pierceable = {{0, 0}, {0, 1}};
  EXPECT_EQ(collider_.overlapped(home(), square(20)), 2u);
}

TEST_F(ColliderTest, FindsTheNeighbourOfAnEnd) {
  build({{{20, 50}, {40, 50}}, {{47, 43}, {100, 43}}});
  EXPECT_TRUE(collider_.hasSegmentNear(home(), {40, 50}, 7, 0));
  EXPECT_FALSE(collider_.hasSegmentNear(home(), {40, 50}, 6, 0));
  EXPECT_TRUE(collider_.hasSegmentNear(home(), {40, 50}, 6, 1));
  EXPECT_TRUE(collider_.hasSegmentNear(home(), {40, 50}, 6, Collider::kNoSegment));
  rules_.pierceable = {{0, 1}};
  EXPECT_FALSE(collider_.hasSegmentNear(home(), {40, 50}, 7, 0)) << "it can be passed";
}

TEST_F(ColliderTest, ClipsAPathAgainstOneSegment) {
  build({{{-100, -30}, {100, -30}}, {{500, 0}, {500, 9}}});
  const auto interval = collider_.clip(home(), {{0, 0}, {0, -80}}, 0);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->enter, (Fraction{1, 4}));
  EXPECT_EQ(interval->exit, (Fraction{1, 2}));
  EXPECT_FALSE(interval->endsInside);
  EXPECT_FALSE(collider_.clip(home(), {{0, 0}, {0, -80}}, 1));
  EXPECT_FALSE(collider_.clip(home(), {{0, 0}, {0, -20}}, 0));
  EXPECT_TRUE(collider_.clip(home(), {{0, 0}, {0, -20}, 1}, 0)) << "with a margin";
  EXPECT_EQ(collider_.hit(home(), {{0, 0}, {0, -80}}, 0)->side, Hit::Side::kSegment);
}

TEST_F(ColliderTest, FindsWarpsWithoutInstanceBehind) {
  world_ = twoStrips();
  Entity entity(world_, square(100));
  MapPart(world_, 1).insert(entity, {0, 0}, Angle());
  instances_.load(world_.geometry(), shapes_, world_.shapeOf(0), world_.entities()[0], world_.instancesOf(0));
  collider_.begin(rules_, entity, instances_, regions_, work_);
  const Collider::Path path{{0, 0}, {1000, 0}, 4};
  const auto find = [&](const std::vector<Collider::WarpRef>& refused) {
    const auto stop = collider_.first(instances_, path.from, path.to);
    return collider_.firstWarp(instances_, path, stop, refused);
  };
  const auto hit = find({});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->segment, 0u);
  EXPECT_EQ(hit->hit.time, (Fraction{896, 1000})) << "900 subunits less the margin";
  EXPECT_FALSE(find({{0, 0}}));
  EXPECT_FALSE(collider_.reachesWarp(instances_, {0, 0}, square(996), 4));
  EXPECT_TRUE(collider_.reachesWarp(instances_, {0, 0}, square(997), 4));
}

// Found by a proof: no place is beside a leg without length.
TEST_F(ColliderTest, AMoveAwayFromALegWithoutLengthMeetsEverySegment) {
  build({{{50, -100}, {50, 100}}});
  collider_.startLeg(instances_, {0, 0});
  std::optional<LegHit> hit;
  collider_.firstIdeal(instances_, 0, {}, {}, hit);
  EXPECT_FALSE(hit);
  EXPECT_TRUE(collider_.isFreeInLeg(instances_, {40, 0}));
  EXPECT_FALSE(collider_.isFreeInLeg(instances_, {41, 0}));
}

// The second part is rotated by 90° against the home part, and has a floor.
class HitFrameTest : public ColliderTest {
 protected:
  HitFrameTest() {
    addPart(world_, 0, {});
    addPart(world_, 1, {{{-100, 480}, {100, 480}}});
    Entity entity(world_, square(10));
    MapPart(world_, 0).insert(entity, {0, 0}, Angle());
    MapPart(world_, 1).insert(entity, {0, 500}, Angle(9000));
    begin(entity);
  }
};

TEST_F(HitFrameTest, LeadsFromThePartOfTheHitToTheHomePart) {
  const auto hit = collider_.first(instances_, {0, 0}, {-30, 0});  // downwards in the second part
  ASSERT_TRUE(hit);
  ASSERT_EQ(hit->placement, 1u);
  EXPECT_EQ(placementOf(instances_, *hit).position, Point(0, 500));
  EXPECT_EQ(segmentOf(instances_, *hit), (Segment{{-100, 480}, {100, 480}}));
  const Point up = normalOf(instances_, *hit);
  EXPECT_TRUE(up.x == 0 && up.y > 0);
  const Point right = homeNormalOf(instances_, *hit);
  EXPECT_TRUE(right.x > 0 && right.y == 0);
  const PrecisePoint displacement{7, 3};
  EXPECT_EQ(fromHome(instances_, *hit, displacement), (PrecisePoint{-3, 7}));
  EXPECT_EQ(toHome(instances_, *hit, fromHome(instances_, *hit, displacement)), displacement);
}

TEST_F(HitFrameTest, InsideOfASegmentTheNormalLeadsToItsLeft) {
  LegHit hit{1, 0, {}};
  hit.hit.side = Hit::Side::kInside;
  EXPECT_EQ(normalOf(instances_, hit), Point(0, 200));
  EXPECT_TRUE(homeNormalOf(instances_, hit).x > 0 && homeNormalOf(instances_, hit).y == 0);
}

TEST_F(HitFrameTest, AHitOfTheHomeInstanceIsInItsFrame) {
  const LegHit hit{};
  const PrecisePoint displacement{7, 3};
  EXPECT_EQ(fromHome(instances_, hit, displacement), displacement);
  EXPECT_EQ(toHome(instances_, hit, displacement), displacement);
}

}  // namespace
}  // namespace platon::collider_test
