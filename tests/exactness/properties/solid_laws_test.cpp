// Rotations of a solid onto itself: a scene and its image must move in the same way.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "platon/game/player.h"
#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "shared/game/face_area.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/properties/solid_symmetry.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/support/run/repetitions.h"

namespace platon::properties::solid_laws_test {
namespace {

using oracle::RandomSource;
using step_check::toPoint;
using Lines = std::vector<std::vector<Segment>>;

constexpr int kTicks = 40;

struct Placement {
  std::uint32_t face = 0;
  Point position;
  Angle angle;

  friend bool operator==(const Placement&, const Placement&) = default;
};

Placement mapped(const SolidSymmetry& symmetry, const Placement& placement) {
  const Angle turn = symmetry.turn(placement.face);
  return {symmetry.images[placement.face].face, rotate(placement.position, turn), placement.angle + turn};
}

Lines mapped(const SolidSymmetry& symmetry, const Lines& lines) {
  Lines images(lines.size());
  for (std::uint32_t face = 0; face < lines.size(); ++face) {
    const Angle turn = symmetry.turn(face);
    for (const Segment& line : lines[face]) {
      images[symmetry.images[face].face].push_back({rotate(line.a, turn), rotate(line.b, turn)});
    }
  }
  return images;
}

/// Records the placement of the home instance after each leg.
class HomePath : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView> instances) override {
    const InstanceView& home = instances.front();
    places.push_back({home.part, home.position, home.angle});
  }

  std::vector<Placement> places;
};

/// Counts contacts.
class ContactCounter : public Rules {
 public:
  void contact(Entity&, const Contact&) override { ++count; }

  int count = 0;
};

/// A world with one ball on a solid.
struct BallWorld {
  BallWorld(SolidKind kind, std::int32_t size, const Lines& lines, const Placement& start)
      : world(buildStage(kind, size, lines)) {
    Entity ball(world, playerShape());
    MapPart(world, start.face).insert(ball, start.position, start.angle);
  }
  Entity ball() { return {world, 0}; }
  std::vector<Placement> advance(Rules& rules) {
    HomePath path;
    world.setRules(rules);
    world.solve(&path);
    return path.places;
  }

  World world;
};

Lines anyLines(SolidKind kind, std::int32_t size, RandomSource& random) {
  const FaceArea area(facePolygon(kind, size));
  Lines lines(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
  const std::int64_t radius = std::int64_t{size} * kSubunitsPerUnit;
  const auto fine = [&] {
    const oracle::Vec v = random.vector(radius);
    return FinePoint{v.x * FinePoint::kPerSubunit, v.y * FinePoint::kPerSubunit};
  };
  for (auto& face : lines) {
    if (const auto clipped = area.clip(fine(), fine()); clipped && random.oneIn(2)) face.push_back(*clipped);
  }
  return lines;
}

std::optional<BallWorld> tryBallWorld(SolidKind kind, std::int32_t size, const Lines& lines, const Placement& start) {
  try {
    return std::optional<BallWorld>(std::in_place, kind, size, lines, start);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Placement anyStart(SolidKind kind, std::int32_t size, RandomSource& random) {
  const auto faces = static_cast<std::size_t>(PlatonicSolid::of(kind).faces());
  return {static_cast<std::uint32_t>(random.below(faces)),
          toPoint(random.vector(std::int64_t{size} * kSubunitsPerUnit / 4)),
          Angle(static_cast<std::int32_t>(random.between(0, Angle::kTurn - 1)))};
}

// Some rotations of the octahedron and the icosahedron only renumber faces. They must not change the motion.
TEST(SolidLawsTest, FaceNumbersDoNotMatter) {
  int renumberings = 0;
  std::int64_t crossings = 0;
  for (const SolidKind kind : {SolidKind::kOctahedron, SolidKind::kIcosahedron}) {
    for (const SolidSymmetry& symmetry : symmetriesOf(PlatonicSolid::of(kind))) {
      if (!symmetry.onlyRenumbers() || symmetry.images[0].face == 0) continue;
      ++renumberings;
      forEachCase(repetitions(200), [&](RandomSource& random) {
        const auto size = static_cast<std::int32_t>(random.between(kMinFaceSize, 300));
        const Lines lines = anyLines(kind, size, random);
        const Placement start = anyStart(kind, size, random);
        auto one = tryBallWorld(kind, size, lines, start);
        if (!one) return;
        BallWorld two(kind, size, mapped(symmetry, lines), mapped(symmetry, start));
        for (int tick = 0; tick < kTicks; ++tick) {
          const Point velocity = toPoint(random.vector(std::int64_t{size} << random.between(0, 10)));
          ContactCounter contacts;
          one->ball().setVelocity(velocity);
          two.ball().setVelocity(velocity);
          auto places = one->advance(contacts);
          for (Placement& placement : places) placement = mapped(symmetry, placement);
          ASSERT_EQ(two.advance(contacts), places) << nameOf(kind) << ", tick " << tick;
        }
        crossings += one->ball().state().crossings;
      });
    }
  }
  EXPECT_EQ(renumberings, 7 + 9);
  EXPECT_GE(crossings, repetitions(5000));
}

// True if no post is near enough to stop or nudge the ball.
bool isClear(const Placement& placement, const std::vector<Point>& polygon) {
  constexpr std::int64_t clearance = kPlayerRadius + 2 * kPostReach;
  for (const Point corner : polygon) {
    if (squaredLength(placement.position - corner) < clearance * clearance) return false;
  }
  return true;
}

// All 24 rotations of the hexahedron are exact on the lattice.
TEST(SolidLawsTest, RotationsOfTheHexahedronPreserveTheMotion) {
  constexpr SolidKind kind = SolidKind::kHexahedron;
  const std::vector<SolidSymmetry> symmetries = symmetriesOf(PlatonicSolid::of(kind));
  ASSERT_EQ(symmetries.size(), 24u);
  std::int64_t crossings = 0;
  forEachCase(repetitions(4000), [&](RandomSource& random) {
    const SolidSymmetry& symmetry = symmetries[random.below(symmetries.size())];
    ASSERT_TRUE(symmetry.isExact());
    const auto size = static_cast<std::int32_t>(random.between(kMinFaceSize, 300));
    const std::vector<Point> polygon = facePolygon(kind, size);
    const Placement start = anyStart(kind, size, random);
    BallWorld one(kind, size, Lines(6), start);
    BallWorld two(kind, size, Lines(6), mapped(symmetry, start));
    const Point velocity = toPoint(random.vector(std::int64_t{size} << random.between(4, 9)));
    one.ball().setVelocity(velocity);
    two.ball().setVelocity(rotate(velocity, symmetry.turn(start.face)));
    ContactCounter contacts;
    const auto clear = [&](const Placement& placement) { return contacts.count == 0 && isClear(placement, polygon); };
    for (int tick = 0; tick < kTicks; ++tick) {
      auto places = one.advance(contacts);
      if (!std::all_of(places.begin(), places.end(), clear)) break;
      for (Placement& placement : places) placement = mapped(symmetry, placement);
      ASSERT_EQ(two.advance(contacts), places) << "tick " << tick;
    }
    crossings += one.ball().state().crossings;
  });
  EXPECT_GE(crossings, repetitions(15000));
}

}  // namespace
}  // namespace platon::properties::solid_laws_test
