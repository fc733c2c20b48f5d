// Straight paths around every solid: position and angle after thousands of crossings.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "platon/game/player.h"
#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "tests/exactness/long_runs/ideal_walk.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/exactness/step_check/run_length.h"

namespace platon::long_runs::straight_walk_test {
namespace {

constexpr std::int32_t kSize = 200;
constexpr std::int32_t kEdge = kSize * kSubunitsPerUnit;

/// A closed straight path, far from all corners, so that no post is hit.
struct Walk {
  const char* name;
  SolidKind kind;
  Point start;      // on face 0
  Point direction;  // direction of the velocity; a lattice vector, so that the path closes exactly
};

// Triangles: parallel to an edge, and at a right angle to an edge, away from the opposite corner. Pentagons: parallel
// to a diagonal, halfway between it and the corner. Squares: parallel to an edge, and diagonally through the middles of
// two edges.
constexpr Walk kWalks[] = {
    {"TetrahedronAlong", SolidKind::kTetrahedron, {0, kEdge / 7}, {1, 0}},
    {"TetrahedronAcross", SolidKind::kTetrahedron, {kEdge / 4, 0}, {0, 1}},
    {"HexahedronAlong", SolidKind::kHexahedron, {0, kEdge / 5}, {1, 0}},
    {"HexahedronDiagonal", SolidKind::kHexahedron, {kEdge / 4, -kEdge / 4}, {1, 1}},
    {"OctahedronAlong", SolidKind::kOctahedron, {0, kEdge / 7}, {1, 0}},
    {"OctahedronAcross", SolidKind::kOctahedron, {kEdge / 4, 0}, {0, 1}},
    {"DodecahedronAlong", SolidKind::kDodecahedron, {0, kEdge * 11 / 20}, {1, 0}},
    {"IcosahedronAlong", SolidKind::kIcosahedron, {0, kEdge / 7}, {1, 0}},
    {"IcosahedronAcross", SolidKind::kIcosahedron, {kEdge / 4, 0}, {0, 1}},
};

// Subunits per tick: from 1/50 of a face to more than one face.
constexpr std::int32_t kSpeeds[] = {4093, 43457, 100003, 302632};

struct Drift {
  std::int64_t crossings = 0;
  std::int64_t ticks = 0;
  long double distance = 0;

  long double perRoot() const { return distance / std::sqrt(static_cast<long double>(crossings)); }
};

// Largest distance from the ideal path at which no post can be hit.
constexpr std::int32_t kClearance = kEdge / 10;

/// Moves an entity along a path and records its drift at each power of two of the crossings and at the end.
class WalkRun {
 public:
  WalkRun(const Walk& walk, std::int32_t speed)
      : velocity_(walk.direction.x * speed, walk.direction.y * speed),
        world_(buildStage(
            walk.kind, kSize,
            std::vector<std::vector<Segment>>(static_cast<std::size_t>(PlatonicSolid::of(walk.kind).faces())))),
        ideal_(walk.kind, kSize, 0, walk.start) {
    Entity entity(world_, playerShape());
    MapPart(world_, 0).insert(entity, walk.start, Angle());
    entity.setVelocity(velocity_);
  }

  // Ends after `crossings` or when the entity leaves the clearance.
  void run(std::int64_t crossings) {
    bool ends = false;
    for (std::int64_t next = 1; !ends && !testing::Test::HasFatalFailure();) {
      step();
      ends = ideal_.crossings() >= crossings || sideways() > kClearance;
      if (ideal_.crossings() < next && !ends) continue;
      drifts.push_back({ideal_.crossings(), ticks_, distance()});
      while (next <= ideal_.crossings()) next *= 2;
    }
  }

  std::vector<Drift> drifts;

 private:
  class NoContactRules : public Rules {
   public:
    void contact(Entity&, const Contact&) override { FAIL() << "contact on a free path"; }
  };

  void step() {
    ideal_.advance(velocity_);
    world_.setRules(rules_);
    world_.solve(&ideal_);
    ++ticks_;
    const EntityState& state = world_.entities()[0];
    ASSERT_EQ(state.heading, ideal_.heading());
    ASSERT_EQ(state.angle, ideal_.heading());
    ASSERT_EQ(state.velocity, velocity_) << "the velocity was rounded";
    ASSERT_EQ(state.crossings, ideal_.crossings());
  }
  oracle::RealVec place() const { return oracle::toReal(step_check::toVec(world_.entities()[0].position)); }
  long double distance() const { return oracle::distance(ideal_.place(), place()); }
  long double sideways() const {
    const oracle::RealVec along = ideal_.turned(velocity_);
    const oracle::RealVec drift{place().x - ideal_.place().x, place().y - ideal_.place().y};
    return std::abs(along.x * drift.y - along.y * drift.x) / std::hypot(along.x, along.y);
  }

  Point velocity_;
  World world_;
  IdealWalk ideal_;
  NoContactRules rules_;
  std::int64_t ticks_ = 0;
};

class StraightWalkTest : public testing::TestWithParam<Walk> {};

/// Each tick rounds one displacement, by at most half the diagonal of a lattice cell; each rehome adds at most one
/// subunit. Independent roundings add up like a square root of their number. On the hexahedron frames rotate by quarter
/// turns, which are exact.
TEST_P(StraightWalkTest, DriftIsAtMostTheSumOfTheRoundingsAndGrowsLikeTheSquareRootOfTheCrossings) {
  const bool exact = GetParam().kind == SolidKind::kHexahedron;
  const std::int64_t crossings = step_check::runLength(10000, 1000000);
  for (const std::int32_t speed : kSpeeds) {
    WalkRun run(GetParam(), speed);
    run.run(crossings);
    for (const Drift& drift : run.drifts) {
      const auto limit =
          exact ? 1e-3L
                : std::sqrt(0.5L) * static_cast<long double>(drift.ticks) + static_cast<long double>(drift.crossings);
      EXPECT_LE(drift.distance, limit) << "at " << speed << " after " << drift.crossings << " crossings";
      EXPECT_LE(drift.perRoot(), 4) << "at " << speed << " after " << drift.crossings << " crossings";
    }
    if (HasFatalFailure()) return;
    const Drift& last = run.drifts.back();
    std::cout << GetParam().name << " at " << speed << ": " << last.crossings << " crossings, drift " << last.distance
              << ", " << last.perRoot() << " times the square root of the crossings\n";
  }
}

INSTANTIATE_TEST_SUITE_P(Walks, StraightWalkTest, testing::ValuesIn(kWalks),
                         [](const auto& described) { return std::string(described.param.name); });

}  // namespace
}  // namespace platon::long_runs::straight_walk_test
