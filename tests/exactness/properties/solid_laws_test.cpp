// Solids are alike from every side: a scene that a rotation of the solid takes to another one goes the same way.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/player.h"
#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "shared/game/face_area.h"
#include "tests/exactness/judge/conversions.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/properties/solid_symmetry.h"

namespace platon::properties {
namespace {

using judge::toPoint;
using oracle::RandomSource;
using Lines = std::vector<std::vector<Segment>>;

constexpr int kTicks = 40;

struct Placed {
  std::uint32_t face = 0;
  Point position;
  Angle angle;

  friend bool operator==(const Placed&, const Placed&) = default;
};

Placed mapped(const SolidSymmetry& symmetry, const Placed& placed) {
  const Angle turn = symmetry.turn(placed.face);
  return {symmetry.images[placed.face].face, rotate(placed.position, turn), placed.angle + turn};
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

/// Where home was after each leg.
class HomePath : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView> instances) override {
    const InstanceView& home = instances.front();
    places.push_back({home.part, home.position, home.angle});
  }

  std::vector<Placed> places;
};

/// Counts what stops the entity.
class Stops : public Rules {
 public:
  void contact(Entity&, const Contact&) override { ++count; }

  int count = 0;
};

/// A ball on a solid; the angle of its shape is that of its frame.
struct Roll {
  Roll(SolidKind kind, std::int32_t size, const Lines& lines, const Placed& start)
      : world(buildStage(kind, size, lines)) {
    Entity ball(world, playerShape());
    MapPart(world, start.face).insert(ball, start.position, start.angle);
  }
  Entity ball() { return {world, 0}; }
  std::vector<Placed> advance(Rules& rules) {
    HomePath path;
    world.solve(rules, &path);
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
    if (const auto cut = area.cut(fine(), fine()); cut && random.oneIn(2)) face.push_back(*cut);
  }
  return lines;
}

std::optional<Roll> tryRoll(SolidKind kind, std::int32_t size, const Lines& lines, const Placed& start) {
  try {
    return std::optional<Roll>(std::in_place, kind, size, lines, start);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Placed anyStart(SolidKind kind, std::int32_t size, RandomSource& random) {
  const auto faces = static_cast<std::size_t>(PlatonicSolid::of(kind).faces());
  return {static_cast<std::uint32_t>(random.below(faces)),
          toPoint(random.vector(std::int64_t{size} * kSubunitsPerUnit / 4)),
          Angle(static_cast<std::int32_t>(random.between(0, Angle::kTurn - 1)))};
}

// Renumbering the faces of octahedron and icosahedron changes nothing at all, whatever is in the way.
TEST(SolidLawsTest, NumbersOfFacesDoNotMatter) {
  int renumberings = 0;
  std::int64_t crossings = 0;
  for (const SolidKind kind : {SolidKind::kOctahedron, SolidKind::kIcosahedron}) {
    for (const SolidSymmetry& symmetry : symmetriesOf(PlatonicSolid::of(kind))) {
      if (!symmetry.onlyRenumbers() || symmetry.images[0].face == 0) continue;
      ++renumberings;
      forEachCase(200, [&](RandomSource& random) {
        const auto size = static_cast<std::int32_t>(random.between(kMinFaceSize, 300));
        const Lines lines = anyLines(kind, size, random);
        const Placed start = anyStart(kind, size, random);
        auto one = tryRoll(kind, size, lines, start);
        if (!one) return;
        Roll two(kind, size, mapped(symmetry, lines), mapped(symmetry, start));
        for (int tick = 0; tick < kTicks; ++tick) {
          const Point velocity = toPoint(random.vector(std::int64_t{size} << random.between(0, 10)));
          Stops stops;
          one->ball().setVelocity(velocity);
          two.ball().setVelocity(velocity);
          auto places = one->advance(stops);
          for (Placed& placed : places) placed = mapped(symmetry, placed);
          ASSERT_EQ(two.advance(stops), places) << nameOf(kind) << ", tick " << tick;
        }
        crossings += one->ball().state().crossings;
      });
    }
  }
  EXPECT_EQ(renumberings, 7 + 9);
  EXPECT_GE(crossings, 5000);
}

// No post is near enough to stop the ball or to nudge it.
bool isClear(const Placed& placed, const std::vector<Point>& polygon) {
  constexpr std::int64_t clearance = kPlayerRadius + 2 * kPostReach;
  for (const Point corner : polygon) {
    if (squaredLength(placed.position - corner) < clearance * clearance) return false;
  }
  return true;
}

// All 24 rotations of the hexahedron are exact on the lattice, and the ball's flight from face to face with them.
TEST(SolidLawsTest, EverySideOfTheHexahedronIsAlike) {
  constexpr SolidKind kind = SolidKind::kHexahedron;
  const std::vector<SolidSymmetry> symmetries = symmetriesOf(PlatonicSolid::of(kind));
  ASSERT_EQ(symmetries.size(), 24u);
  std::int64_t crossings = 0;
  forEachCase(4000, [&](RandomSource& random) {
    const SolidSymmetry& symmetry = symmetries[random.below(symmetries.size())];
    ASSERT_TRUE(symmetry.isExact());
    const auto size = static_cast<std::int32_t>(random.between(kMinFaceSize, 300));
    const std::vector<Point> polygon = facePolygon(kind, size);
    const Placed start = anyStart(kind, size, random);
    Roll one(kind, size, Lines(6), start);
    Roll two(kind, size, Lines(6), mapped(symmetry, start));
    const Point velocity = toPoint(random.vector(std::int64_t{size} << random.between(4, 9)));
    one.ball().setVelocity(velocity);
    two.ball().setVelocity(rotate(velocity, symmetry.turn(start.face)));
    Stops stops;
    const auto clear = [&](const Placed& placed) { return stops.count == 0 && isClear(placed, polygon); };
    for (int tick = 0; tick < kTicks; ++tick) {
      auto places = one.advance(stops);
      if (!std::all_of(places.begin(), places.end(), clear)) break;
      for (Placed& placed : places) placed = mapped(symmetry, placed);
      ASSERT_EQ(two.advance(stops), places) << "tick " << tick;
    }
    crossings += one.ball().state().crossings;
  });
  EXPECT_GE(crossings, 15000);
}

}  // namespace
}  // namespace platon::properties
