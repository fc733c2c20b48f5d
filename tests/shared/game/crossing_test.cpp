// Entities that cross the edges of every solid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/player.h"
#include "platon/game/solid.h"
#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "shared/physics/step/step_state.h"
#include "tests/shared/game/real_face.h"
#include "tests/shared/physics/step/leg_checker.h"
#include "tests/sim/seeded_random.h"
#include "tests/support/run/repetitions.h"

namespace platon::crossing_test {
namespace {

constexpr std::uint64_t kSeed = 90210;

using Lines = std::vector<std::vector<Segment>>;

Lines noLines(SolidKind kind) { return Lines(static_cast<std::size_t>(PlatonicSolid::of(kind).faces())); }

// A solid with one entity on it.
struct Walk {
  Walk(SolidKind kind, std::int32_t size, const Lines& lines, int face, Real at, Angle angle = {})
      : world(buildStage(kind, size, lines)), entity(world, playerShape()) {
    MapPart(world, static_cast<std::uint32_t>(face)).insert(entity, nearest(at), angle);
  }

  World world;
  Entity entity;
};

std::string name(SolidKind kind, int face, int edge) {
  return std::string(nameOf(kind)) + ", face " + std::to_string(face) + ", edge " + std::to_string(edge);
}

template <class Visit>
void forEachEdge(Visit&& visit) {
  for (const SolidKind kind : kAllSolids) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    for (int face = 0; face < solid.faces(); ++face) {
      for (int edge = 0; edge < solid.edgesPerFace() && !testing::Test::HasFatalFailure(); ++edge)
        visit(kind, face, edge);
    }
  }
}

TEST(CrossingTest, WarpsRotateAboutTheMidpointsOfEdges) {
  for (const std::int32_t size : {200, 333, 480, 65536}) {
    forEachEdge([&](SolidKind kind, int face, int edge) {
      const RealFace ideal(kind, size);
      const World world = buildStage(kind, size, noLines(kind));
      const Warp& warp = world.geometry().parts[static_cast<std::size_t>(face)]->warps[static_cast<std::size_t>(edge)];
      const auto real = [](PrecisePoint p) {
        return Real{static_cast<double>(p.x) / PrecisePoint::kOne, static_cast<double>(p.y) / PrecisePoint::kOne};
      };
      const double reach = std::ldexp(1024.0 * size, -28) + std::ldexp(1.0, -16);
      ASSERT_LT(length(real(warp.fromMiddle) - ideal.middle(edge)), reach) << name(kind, face, edge) << " " << size;
      ASSERT_LT(length(real(warp.ontoMiddle) - ideal.over(face, edge, ideal.middle(edge))), reach);
    });
  }
}

// Moves an entity over an edge and back.
void crossAndReturn(SolidKind kind, std::int32_t size, int face, int edge, double along, double slant) {
  const RealFace ideal(kind, size);
  const PlatonicSolid::Neighbour& behind = PlatonicSolid::of(kind).neighbour(face, edge);
  const Real direction = turned(ideal.outwards(edge), Angle(static_cast<std::int32_t>(slant * 100)));
  const Angle start(4321);
  Walk walk(kind, size, noLines(kind), face, ideal.onEdge(edge, along) - 17000 * direction, start);
  LegChecker checker(walk.world);
  const Point from = walk.entity.position();
  const Point velocity = nearest(3400 * direction);
  walk.entity.setVelocity(velocity);
  for (int tick = 0; tick < 10; ++tick) walk.world.solve(&checker);
  ASSERT_EQ(walk.entity.part(), behind.face);
  ASSERT_EQ(walk.entity.rotation(), start + behind.turn);
  ASSERT_EQ(walk.entity.state().crossings, 1u);
  const Real expected = ideal.over(face, edge, real(from) + 10 * real(velocity));
  // Every tick behind the edge rounds the displacement once.
  ASSERT_LE(length(real(walk.entity.position()) - expected), 3 + 5 * 0.71);
  walk.entity.setVelocity(nearest(-10 * real(walk.entity.velocity())));
  walk.world.solve(&checker);
  ASSERT_EQ(walk.entity.part(), static_cast<std::uint32_t>(face));
  ASSERT_EQ(walk.entity.rotation(), start);
  ASSERT_LE(length(real(walk.entity.position() - from)), 3 + 5 * 0.71 + 7.1);
  ASSERT_EQ(checker.faults(), "");
}

TEST(CrossingTest, CrossesEveryEdgeAtManyPlacesAndAngles) {
  forEachEdge([](SolidKind kind, int face, int edge) {
    for (const std::int32_t size : {200, 480, 65536}) {
      for (const double along : {0.3, 0.5, 0.68}) {
        for (const double slant : {-40.0, -7.77, 0.0, 23.0, 40.0}) {
          ASSERT_NO_FATAL_FAILURE(crossAndReturn(kind, size, face, edge, along, slant))
              << name(kind, face, edge) << ", size " << size << ", at " << along << ", slant " << slant;
        }
      }
    }
  });
}

TEST(CrossingTest, CrossingAndReturningEndsWithin3Subunits) {
  sim::SeededRandom random(kSeed);
  forEachEdge([&](SolidKind kind, int face, int edge) {
    const RealFace ideal(kind, 480);
    for (int round = 0; round < 5; ++round) {
      const double along = 0.3 + static_cast<double>(random.below(400)) / 1000;
      Walk walk(kind, 480, noLines(kind), face, ideal.onEdge(edge, along) - 15000 * ideal.outwards(edge));
      const Point from = walk.entity.position();
      walk.entity.setVelocity(nearest(28000 * ideal.outwards(edge)) + random.vector(5000));
      walk.world.solve();
      ASSERT_NE(walk.entity.part(), static_cast<std::uint32_t>(face));
      walk.entity.setVelocity(-walk.entity.velocity());
      walk.world.solve();
      ASSERT_EQ(walk.entity.part(), static_cast<std::uint32_t>(face));
      ASSERT_EQ(walk.entity.rotation(), Angle());
      ASSERT_LE(squaredLength(walk.entity.position() - from), 9) << name(kind, face, edge) << ", seed " << kSeed;
    }
  });
}

TEST(CrossingTest, RepeatedCrossingsDoNotDrift) {
  const std::uint32_t kCrossings = repetitions(100000u);
  for (const SolidKind kind : kAllSolids) {
    const RealFace ideal(kind, 480);
    const int edge = 1;
    Walk walk(kind, 480, noLines(kind), 0, ideal.onEdge(edge, 0.4) - 3 * ideal.outwards(edge));
    const Real from = real(walk.entity.position());
    const PlatonicSolid::Neighbour& behind = PlatonicSolid::of(kind).neighbour(0, edge);
    const Point step = nearest(7 * ideal.outwards(edge));
    LegChecker checker(walk.world);
    for (std::uint32_t tick = 0; tick < kCrossings; ++tick) {
      walk.entity.setVelocity(tick % 2 == 0 ? step : -step, walk.entity.rotation());
      const bool watched = tick % 1000 < 4;
      if (tick % 1000 == 0) checker.forget();
      walk.world.solve(watched ? &checker : nullptr);
    }
    EXPECT_EQ(checker.faults(), "") << nameOf(kind);
    EXPECT_GE(walk.entity.state().crossings, kCrossings / 100 * 99) << nameOf(kind);
    const bool back = walk.entity.part() == 0;
    const Real at =
        back ? real(walk.entity.position()) : ideal.over(behind.face, behind.edge, real(walk.entity.position()));
    EXPECT_LE(length(at - from), back ? 4.0 : 12.0) << nameOf(kind);
  }
}

double distanceFromCorners(const RealFace& ideal, int corners, Point at) {
  double least = length(ideal.corner(0) - real(at));
  for (int corner = 1; corner < corners; ++corner) least = std::min(least, length(ideal.corner(corner) - real(at)));
  return least;
}

// The shape never contains a vertex of the solid.
TEST(CrossingTest, CornersBlock) {
  constexpr double apothem = 12051;
  for (const SolidKind kind : kAllSolids) {
    const int corners = PlatonicSolid::of(kind).edgesPerFace();
    const RealFace ideal(kind, 200);
    for (int face = 0; face < PlatonicSolid::of(kind).faces(); ++face) {
      for (int corner = 0; corner < corners; ++corner) {
        for (const double aside : {-0.3, -0.05, 0.0, 0.01, 0.25}) {
          Walk walk(kind, 200, noLines(kind), face, {0, 0});
          LegChecker checker(walk.world);
          const Real towards = (1 / length(ideal.corner(corner))) * ideal.corner(corner);
          walk.entity.setVelocity(nearest(4000 * (towards + aside * left(towards))));
          double least = 1e9;
          for (int tick = 0; tick < 60; ++tick) {
            walk.world.solve(&checker);
            least = std::min(least, distanceFromCorners(ideal, corners, walk.entity.position()));
          }
          ASSERT_EQ(checker.faults(), "") << name(kind, face, corner);
          ASSERT_GE(least, apothem) << name(kind, face, corner) << ", aside " << aside;
          if (aside == 0.0) {
            ASSERT_LE(least, apothem + 300) << name(kind, face, corner);
          }
        }
      }
    }
  }
}

TEST(CrossingTest, AnEntityPushedIntoACornerRests) {
  Walk walk(SolidKind::kHexahedron, 200, noLines(SolidKind::kHexahedron), 0, {0, 0});
  walk.entity.setVelocity({3000, 3000});
  for (int tick = 0; tick < 60; ++tick) walk.world.solve();
  const Point before = walk.entity.position();
  EXPECT_EQ(before.x, before.y);
  EXPECT_EQ(walk.entity.part(), 0u);
  for (int tick = 0; tick < 1000; ++tick) walk.world.solve();
  EXPECT_EQ(walk.entity.position(), before);
}

// Random segments on every face, and one entity at a free position.
Walk flungWalk(SolidKind kind, std::int32_t size, int linesPerFace, sim::SeededRandom& random) {
  Lines lines = noLines(kind);
  const auto reach = static_cast<std::int32_t>(RealFace(kind, size).inradius());
  for (auto& face : lines) {
    for (int i = 0; i < linesPerFace; ++i) {
      const Point a = random.vector(reach * 9 / 10);
      face.push_back({a, i % 8 == 0 ? a : nearest(0.9 * real(random.vector(reach)))});
    }
  }
  for (;;) {
    try {
      return Walk(kind, size, lines, 0, 0.8 * real(random.vector(reach)));
    } catch (const std::invalid_argument&) {
    }
  }
}

struct Fling {
  std::int32_t size;
  std::int32_t speed;
  int lines;
  int ticks;
  int hold;  // ticks between changes of the velocity
};

constexpr std::int32_t kMaxTurn = 2000;  // centidegrees a step

void fling(SolidKind kind, const Fling& how) {
  sim::SeededRandom random(kSeed + static_cast<std::uint64_t>(how.speed));
  Walk walk = flungWalk(kind, how.size, how.lines, random);
  Entity entity(walk.world, 0);
  LegChecker checker(walk.world);
  std::uint64_t largest = 0;
  std::vector<bool> visited(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
  for (int tick = 0; tick < how.ticks; ++tick) {
    const std::uint64_t before = checker.legs();
    if (tick % how.hold == 0) entity.setVelocity(random.vector(how.speed));
    if (tick % 5 == 0) entity.rotate(static_cast<std::int32_t>(random.below(2 * kMaxTurn)) - kMaxTurn);
    walk.world.solve(&checker);
    largest = std::max(largest, checker.legs() - before);
    visited[entity.part()] = true;
    ASSERT_EQ(checker.faults(), "") << nameOf(kind) << ", tick " << tick << ", seed " << kSeed;
    ASSERT_TRUE(walk.world.accepts(walk.world.save()));
    const Real centre = real(entity.position());
    ASSERT_LT(length(centre), 2.01 * RealFace(kind, how.size).inradius() + 8)
        << "the home instance is far outside its face";
  }
  // The observer is called up to four times per leg: for inserted instances, the move, a rehome and removed instances.
  // A rotation close to segments is divided into many parts, with a call for each.
  EXPECT_GT(largest, 0u) << nameOf(kind) << ": no leg was observed";
  EXPECT_LE(largest, 16u * StepLimits::kMaxLegs) << nameOf(kind);
  if (how.lines == 0) {
    EXPECT_EQ(std::count(visited.begin(), visited.end(), false), 0) << nameOf(kind) << ": some face was not visited";
  }
}

TEST(CrossingTest, InvariantsHoldAmongSegments) {
  for (const SolidKind kind : kAllSolids) {
    ASSERT_NO_FATAL_FAILURE(fling(kind, {480, 20000, 4, 1500, 20}));
    ASSERT_NO_FATAL_FAILURE(fling(kind, {200, 8000, 3, 1500, 30}));
    ASSERT_NO_FATAL_FAILURE(fling(kind, {200, 3000, 12, 800, 1}));
  }
}

TEST(CrossingTest, InvariantsHoldOverDozensOfFacesInATick) {
  for (const SolidKind kind : kAllSolids) {
    ASSERT_NO_FATAL_FAILURE(fling(kind, {200, 2000000, 0, 300, 1}));
    ASSERT_NO_FATAL_FAILURE(fling(kind, {200, 1 << 27, 0, 150, 1}));
    ASSERT_NO_FATAL_FAILURE(fling(kind, {200, 1 << 27, 3, 60, 1}));
    ASSERT_NO_FATAL_FAILURE(fling(kind, {65536, 1 << 27, 1, 100, 1}));
  }
}

// A displacement of three turns around the cube ends where it began.
TEST(CrossingTest, GoesStraightAroundTheCube) {
  for (const Point direction : {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)}) {
    Walk walk(SolidKind::kHexahedron, 200, noLines(SolidKind::kHexahedron), 0, {100, -300});
    const std::int32_t tour = 4 * 200 * 1024;
    walk.entity.setVelocity({direction.x * tour * 3, direction.y * tour * 3});
    LegChecker checker(walk.world);
    walk.world.solve(&checker);
    EXPECT_EQ(checker.faults(), "");
    EXPECT_EQ(walk.entity.part(), 0u);
    EXPECT_EQ(walk.entity.position(), Point(100, -300));
    EXPECT_EQ(walk.entity.rotation(), Angle());
    EXPECT_EQ(walk.entity.state().crossings, 12u);
  }
}

}  // namespace
}  // namespace platon::crossing_test
