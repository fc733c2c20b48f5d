// I4: an entity that rests under a constant velocity never moves again, not by one bit.
#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/player.h"
#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "shared/game/face_area.h"
#include "tests/exactness/long_runs/every_step.h"
#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/shared/game/real_face.h"

namespace platon::long_runs::long_rest_test {
namespace {

constexpr std::int32_t kSize = 240;
constexpr int kSettling = 1000;

/// Segments that hold the entity, in subunits. The frame unfolds a face and its neighbour into one plane: the origin is
/// on their common edge, x points across the edge, rotated by the slant, and y is a quarter turn counter-clockwise of
/// x.
struct Support {
  const char* name;
  std::vector<std::pair<Real, Real>> lines;
  Real start;
  Real velocity;  // subunits per tick
};

std::vector<Support> supports() {
  return {
      {"floor", {{{-60000, 0}, {60000, 0}}}, {0, 13000}, {0, -256}},
      {"wedge", {{{-900, 0}, {-40000, 30000}}, {{-900, 0}, {25000, 44000}}}, {0, 34000}, {40, -300}},
      {"blunt wedge", {{{0, -9000}, {-50000, 1000}}, {{0, -9000}, {50000, 3000}}}, {3000, 12000}, {0, -256}},
      {"corner over the edge",
       {{{-60000, -7000}, {9000, -7000}}, {{9000, -9000}, {12000, 50000}}},
       {-5000, 9000},
       {200, -256}},
  };
}

/// Where a support is on a solid.
struct Place {
  SolidKind kind;
  int face = 0;
  int edge = 0;
  double before = 0;  // distance of the origin before the edge, subunits
  double slant = 0;   // degrees
};

std::ostream& operator<<(std::ostream& out, const Place& place) {
  return out << nameOf(place.kind) << ", face " << place.face << ", edge " << place.edge << ", " << place.before
             << " before it, slant " << place.slant;
}

FinePoint fine(Real point) {
  const Point rounded = nearest(point);
  return {std::int64_t{rounded.x} * FinePoint::kPerSubunit, std::int64_t{rounded.y} * FinePoint::kPerSubunit};
}

class RestingBall {
 public:
  RestingBall(const Support& support, const Place& place)
      : place_(place), ideal_(place.kind, kSize), world_(stage(support)) {
    Entity entity(world_, playerShape());
    const auto angle = platon::rotationOf(turn({1, 0}));
    const PlatonicSolid::Neighbour& behind = PlatonicSolid::of(place.kind).neighbour(place.face, place.edge);
    const bool isBehind = !FaceArea(facePolygon(place.kind, kSize)).contains(nearest(at(support.start)));
    const Real start = isBehind ? ideal_.over(place.face, place.edge, at(support.start)) : at(support.start);
    MapPart(world_, isBehind ? behind.face : static_cast<std::uint32_t>(place.face))
        .insert(entity, nearest(start), isBehind ? angle + behind.turn : angle);
    entity.setVelocity(rotate(nearest(turn(support.velocity)), entity.rotation() - angle));
  }

  World& world() { return world_; }

 private:
  Real turn(Real vector) const {
    return turned(vector, platon::rotationOf(ideal_.outwards(place_.edge)) +
                              Angle(static_cast<std::int32_t>(place_.slant * 100)));
  }
  Real at(Real point) const {
    return ideal_.onEdge(place_.edge, 0.5) - place_.before * ideal_.outwards(place_.edge) + turn(point);
  }
  World stage(const Support& support) const {
    const FaceArea area(facePolygon(place_.kind, kSize));
    std::vector<std::vector<Segment>> lines(static_cast<std::size_t>(PlatonicSolid::of(place_.kind).faces()));
    const auto add = [&](int face, Real a, Real b) {
      if (const auto clipped = area.clip(fine(a), fine(b))) lines[static_cast<std::size_t>(face)].push_back(*clipped);
    };
    const int behind = PlatonicSolid::of(place_.kind).neighbour(place_.face, place_.edge).face;
    for (const auto& [a, b] : support.lines) {
      add(place_.face, at(a), at(b));
      add(behind, ideal_.over(place_.face, place_.edge, at(a)), ideal_.over(place_.face, place_.edge, at(b)));
    }
    return buildStage(place_.kind, kSize, lines);
  }

  Place place_;
  RealFace ideal_;
  World world_;
};

/// Counts contacts.
class ContactCounter : public Rules {
 public:
  void contact(Entity&, const Contact&) override { ++count; }

  int count = 0;
};

/// Computes half of the steps; the world repeats the others from its memory of bodies at rest. Position, remainder and
/// instances must stay the same.
void expectSame(World& world, const WorldState& settled, std::int64_t ticks) {
  EveryStep everyStep;
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    tick % 2 == 0 ? world.solve() : world.solve(&everyStep);
    ASSERT_EQ(world.entities()[0], settled.entities[0]) << "moved in tick " << tick;
  }
  ASSERT_EQ(world.save(), settled);
  ASSERT_GE(everyStep.calls, (ticks + 1) / 2);
}

void expectRest(const Support& support, const Place& place, std::int64_t ticks) {
  SCOPED_TRACE(testing::Message() << support.name << " on " << place);
  RestingBall rest(support, place);
  World& world = rest.world();
  for (int tick = 0; tick < kSettling; ++tick) world.solve();
  const WorldState settled = world.save();
  ContactCounter contacts;
  const Convex shape = playerShape();
  step_check::StepChecker checker({world.geometry(), shape, place.kind, kSize});
  world.setRules(contacts);
  world.solve(&checker);
  world.resetRules();
  ASSERT_EQ(checker.finishTick(), "");
  ASSERT_GT(contacts.count, 0) << "no contact";
  expectSame(world, settled, ticks);
}

class RestTest : public testing::TestWithParam<SolidKind> {};

TEST_P(RestTest, NothingMovesUnderAConstantVelocity) {
  const std::int64_t ticks = step_check::runLength(100000, 1000000);
  int placed = 0;
  for (const Support& support : supports()) {
    for (const double before : {0.0, 700.0}) {
      const double slant = placed % 2 == 0 ? 20.0 : -12.3;
      ASSERT_NO_FATAL_FAILURE(expectRest(support, {GetParam(), placed % 4, placed % 3, before, slant}, ticks));
      ++placed;
    }
  }
}

// Every edge of the solid, for fewer ticks.
TEST_P(RestTest, NothingMovesAtEveryEdge) {
  const PlatonicSolid& solid = PlatonicSolid::of(GetParam());
  const std::int64_t ticks = step_check::runLength(100, 10000);
  for (const Support& support : supports()) {
    for (int face = 0; face < solid.faces(); ++face) {
      for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
        for (const double slant : {-33.0, 7.7}) {
          ASSERT_NO_FATAL_FAILURE(expectRest(support, {GetParam(), face, edge, 40, slant}, ticks));
        }
      }
    }
  }
}

/// Two segments that meet near an edge. A body that is pressed into the wedge starts above its tip.
Support randomWedge(oracle::RandomSource& random) {
  const Angle axis = Angle::degrees(static_cast<std::int32_t>(random.between(30, 150)));
  const auto half = Angle::degrees(static_cast<std::int32_t>(random.between(30, 75)));
  const Real tip{static_cast<double>(random.between(-20000, 20000)), static_cast<double>(random.between(-20000, 0))};
  const auto along = [&](Angle angle, double length) { return turned({length, 0}, angle); };
  const auto noise = [&] { return static_cast<double>(random.between(-60, 60)); };
  return {"wedge",
          {{tip, tip + along(axis - half, 60000)}, {tip, tip + along(axis + half, 60000)}},
          tip + along(axis, 30000),
          along(axis, -256) + Real{noise(), noise()}};
}

/// Returns false if the ball does not start freely or does not come to rest.
bool restsForEver(const Support& support, const Place& place, std::int64_t ticks) {
  std::optional<RestingBall> rest;
  try {
    rest.emplace(support, place);
  } catch (const std::invalid_argument&) {
    return false;
  }
  World& world = rest->world();
  for (int tick = 0; tick < kSettling; ++tick) world.solve();
  const WorldState settled = world.save();
  EveryStep everyStep;
  world.solve(&everyStep);
  if (world.save() != settled) return false;
  expectSame(world, settled, ticks);
  return true;
}

TEST_P(RestTest, NothingMovesInAHundredRandomWedges) {
  const std::int64_t ticks = step_check::runLength(2000, 1000000);
  const PlatonicSolid& solid = PlatonicSolid::of(GetParam());
  oracle::RandomSource random(properties::firstSeed());
  int rests = 0;
  for (int tries = 0; rests < 100 && !HasFatalFailure(); ++tries) {
    ASSERT_LT(tries, 400) << "too few wedges hold the ball";
    const Support wedge = randomWedge(random);
    const Place place{GetParam(), static_cast<int>(random.between(0, solid.faces() - 1)),
                      static_cast<int>(random.between(0, solid.edgesPerFace() - 1)),
                      static_cast<double>(random.between(-2000, 9000)), static_cast<double>(random.between(-180, 180))};
    SCOPED_TRACE(testing::Message() << "wedge " << tries << " on " << place << ", seed " << properties::firstSeed());
    rests += restsForEver(wedge, place, ticks) ? 1 : 0;
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, RestTest, testing::ValuesIn(kAllSolids),
                         [](const auto& described) { return std::string(nameOf(described.param)); });

}  // namespace
}  // namespace platon::long_runs::long_rest_test
