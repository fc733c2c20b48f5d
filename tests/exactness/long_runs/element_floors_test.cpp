// Floors of elements, over the edges of every solid: they hold a player that stands on them (I4) or runs over them, on
// both faces, whatever their slope.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/real_face.h"

namespace platon::long_runs::element_floors_test {
namespace {

using oracle::RandomSource;

constexpr std::int32_t kSize = 480;
constexpr double kReach = 90 * 1024.0;  // length of a floor on either side of the edge
// A one-way segment does not hold a player that is farther below than this, in subunits.
constexpr double kOnewaySlack = 64;

std::string written(Real point) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4f %.4f ", point.x / kSubunitsPerUnit, point.y / kSubunitsPerUnit);
  return text;
}

/// A straight floor over the middle of an edge, and a player above it. Angles are whole degrees.
struct Floor {
  SolidKind kind;
  int face;
  int edge;
  int slant;                 ///< from the outward normal of the edge to the direction of the floor
  int tilt;                  ///< from the player's right to the direction of the floor
  std::string word;          ///< without the number of `up`
  double before = 40;        ///< where the player is above the floor: units before the edge
  double height = 14;        ///< of its centre above the floor
  std::string further = {};  ///< more lines of the face

  RealFace ideal() const { return {kind, kSize}; }
  PlatonicSolid::Neighbour behind() const { return PlatonicSolid::of(kind).neighbour(face, edge); }
  int apart() const { return 360 / PlatonicSolid::of(kind).edgesPerFace(); }
  /// Of the player's up, from the +y of the face: edge 0 points down.
  int degrees() const { return ((edge * apart() + slant - tilt - 90) % 360 + 360) % 360; }
  Real direction() const { return turned(ideal().outwards(edge), Angle::degrees(slant)); }
  Real up() const { return left(direction()); }
  Real at(double along, double above) const {
    return ideal().middle(edge) + (along * kSubunitsPerUnit) * direction() + (above * kSubunitsPerUnit) * up();
  }
  /// The word of the part of the floor on a face on which the player's up is at this angle.
  std::string wordAt(int upDegrees) const {
    if (word != "up") return word;
    return "up " + std::to_string(((upDegrees + 180) % 360 + apart() / 2) % 360 / apart());
  }
  std::string line(double above, const std::string& words) const {
    return written(at(-kReach / 1024, above)) + written(at(kReach / 1024, above)) + words + "\n";
  }
  std::shared_ptr<const Level> level() const {
    std::vector<std::string> lines(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
    const auto over = [&](Real point) { return ideal().over(face, edge, point); };
    lines[static_cast<std::size_t>(face)] = line(0, wordAt(degrees())) + further;
    lines[behind().face] = written(over(at(-kReach / 1024, 0))) + written(over(at(kReach / 1024, 0))) +
                           wordAt((degrees() + behind().turn.centidegrees() / 100) % 360);
    std::string text = std::string(nameOf(kind)) + "\n" + std::to_string(face) + " " + written(at(-before, height)) +
                       std::to_string(degrees()) + "\n" + std::to_string(face) + " 0 0\n" + std::to_string(kSize) +
                       "\n";
    for (const std::string& own : lines) text += "%\n" + own + "\n";
    return levelOf(text);
  }
  /// The player's place along and above the floor, seen from the middle of the edge.
  Real placeOf(const EntityState& entity) const {
    Real place = real(entity.position);
    if (entity.part != static_cast<std::uint32_t>(face))
      place = ideal().over(static_cast<int>(behind().face), behind().edge, place);
    place = place - ideal().middle(edge);
    return {dot(place, direction()), dot(place, up())};
  }
};

std::ostream& operator<<(std::ostream& out, const Floor& floor) {
  return out << nameOf(floor.kind) << ", face " << floor.face << ", edge " << floor.edge << ", slant " << floor.slant
             << ", tilt " << floor.tilt << ", " << floor.word << ", " << floor.before << " before the edge";
}

/// A game on a floor, each step of which the oracle checks.
class FloorGame : public PlayedGame {
 public:
  explicit FloorGame(const Floor& floor)
      : PlayedGame(floor.level()),
        floor_(floor),
        checker_({game.world().geometry(), shape_, floor.kind, kSize, {}, game.level().elements}) {}

  void tick(std::uint8_t buttons) {
    const OpenElements open = game.open();
    const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    game.advance(std::vector<Input>{input}, &checker_);
    ASSERT_EQ(checker_.finishTick(open), "");
  }
  Real place() const { return floor_.placeOf(entity()); }

 private:
  Floor floor_;
  const Convex shape_ = playerShape();
  step_check::StepChecker checker_;
};

const std::vector<std::string>& words() {
  static const std::vector<std::string> all = {"oneway", "up", "plate 1", "door 2"};
  return all;
}

class ElementFloorsTest : public testing::TestWithParam<SolidKind> {};

TEST_P(ElementFloorsTest, NothingMovesAndNoPlateFlickersUnderAStandingPlayer) {
  const std::int64_t ticks = step_check::runLength(100000, 1000000);
  for (const std::string& word : words()) {
    for (const auto& [before, tilt] : {std::pair(0.0, 0), std::pair(0.7, 17), std::pair(30.0, -31)}) {
      const Floor floor{GetParam(), 1, 2, 20, tilt, word, before};
      SCOPED_TRACE(testing::Message() << floor);
      PlayedGame played(floor.level());
      played.run(1000, kNone);
      ASSERT_TRUE(played.grounded());
      const WorldState rest = played.game.world().save();
      const PlayerState player = played.player();
      for (std::int64_t tick = 0; tick < ticks; ++tick) {
        played.run(1, kNone);
        ASSERT_EQ(played.entity(), rest.entities[0]) << tick;
        ASSERT_EQ(played.player(), player) << tick;
        ASSERT_EQ(played.game.openDoors(), word == "plate 1" ? 2U : 0U) << tick;
      }
      ASSERT_EQ(played.game.world().save(), rest);
    }
  }
}

// There and back over every edge. The floor is rounded where it meets the edge, and the position is on the lattice.
TEST_P(ElementFloorsTest, APlayerRunsOverEveryEdgeOnBothFaces) {
  const PlatonicSolid& solid = PlatonicSolid::of(GetParam());
  for (int face = 0; face < solid.faces(); ++face) {
    for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
      const std::string& word = words()[static_cast<std::size_t>(face + edge) % words().size()];
      for (const auto& [slant, tilt] : {std::pair(0, 0), std::pair(-25, 14), std::pair(31, -30)}) {
        const Floor floor{GetParam(), face, edge, slant, tilt, word};
        SCOPED_TRACE(testing::Message() << floor);
        FloorGame played(floor);
        for (int tick = 0; tick < 60; ++tick) ASSERT_NO_FATAL_FAILURE(played.tick(kNone));
        const double height = played.place().y;
        for (int tick = 0; tick < 70; ++tick) {
          ASSERT_NO_FATAL_FAILURE(played.tick(tick < 32 ? Input::kRight : Input::kLeft));
          ASSERT_NEAR(played.place().y, height, 4) << "tick " << tick;
          ASSERT_TRUE(played.grounded()) << "tick " << tick;
          ASSERT_EQ(played.game.openDoors(), word == "plate 1" ? 2U : 0U) << "tick " << tick;
          if (tick == 31) {
            ASSERT_GT(played.place().x, 30 * 1024);
          }
        }
        ASSERT_LT(played.place().x, -30 * 1024);
      }
    }
  }
}

TEST_P(ElementFloorsTest, AHazardIsTouchedOnBothFaces) {
  for (const double before : {30.0, 0.0, -8.0}) {
    const Floor floor{GetParam(), 0, 1, 20, 10, "hazard", before, 40};
    SCOPED_TRACE(testing::Message() << floor);
    FloorGame played(floor);
    ASSERT_NO_FATAL_FAILURE(played.tick(kNone));
    int returns = 0;
    for (int tick = 0; tick < 200; ++tick) {
      ASSERT_NO_FATAL_FAILURE(played.tick(kNone));
      ASSERT_FALSE(played.grounded()) << "tick " << tick;
      const bool isBack = played.player().velocity == Point();
      returns += isBack ? 1 : 0;
      ASSERT_TRUE(!isBack || played.entity().position == played.game.level().start);
    }
    EXPECT_GT(returns, 5);
  }
}

TEST_P(ElementFloorsTest, APlayerJumpsThroughAOnewaySegmentOntoIt) {
  for (const auto& [before, slant] : {std::pair(40.0, 20), std::pair(12.0, 20), std::pair(6.0, -20)}) {
    Floor floor{GetParam(), 2, 0, slant, 0, "oneway", before};
    FloorGame above(floor);
    for (int tick = 0; tick < 60; ++tick) ASSERT_NO_FATAL_FAILURE(above.tick(kNone));
    floor.height = 14 - 40;
    floor.further = floor.line(-40, "");
    SCOPED_TRACE(testing::Message() << floor);
    FloorGame below(floor);
    for (int tick = 0; tick < 30; ++tick) ASSERT_NO_FATAL_FAILURE(below.tick(kNone));
    ASSERT_TRUE(below.grounded());
    for (int tick = 0; tick < 90; ++tick) ASSERT_NO_FATAL_FAILURE(below.tick(tick < 45 ? Input::kJump : kNone));
    EXPECT_TRUE(below.grounded());
    EXPECT_NEAR(below.place().y, above.place().y, 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, ElementFloorsTest, testing::ValuesIn(kAllSolids),
                         [](const auto& described) { return std::string(nameOf(described.param)); });

/// A chain of slopes from left to right, with ends that are off by up to two subunits; most are one-way.
class Chain {
 public:
  explicit Chain(RandomSource& random) {
    Point end{-units(225), -units(60)};
    while (end.x < units(215)) {
      const auto width = static_cast<std::int32_t>(random.between(6, 50)) * kSubunitsPerUnit;
      const auto rise = static_cast<std::int32_t>(random.between(-width * 3 / 10, width * 3 / 10));
      const Point next{std::min(end.x + width, units(225)), std::clamp(end.y + rise, -units(150), units(60))};
      segments_.push_back({end + noise(random), next + noise(random)});
      end = next;
      text_ += lineOf(segments_.back()) + (random.oneIn(4) ? "\n" : "oneway\n");
    }
  }

  std::string text() const { return text_; }
  /// The distance of a point from the nearest segment.
  double distance(Point point) const {
    double least = 1e9;
    for (const Segment& segment : segments_) {
      const Real along = real(segment.b - segment.a);
      const Real fromA = real(point - segment.a);
      const double part = std::clamp(dot(fromA, along) / dot(along, along), 0.0, 1.0);
      least = std::min(least, length(fromA - part * along));
    }
    return least;
  }

 private:
  static Point noise(RandomSource& random) {
    const oracle::Vec offset = random.vector(2);
    return {static_cast<std::int32_t>(offset.x), static_cast<std::int32_t>(offset.y)};
  }
  static std::string lineOf(const Segment& segment) { return written(real(segment.a)) + written(real(segment.b)); }

  std::vector<Segment> segments_;
  std::string text_;
};

// The ball stays above the chain, whatever it does. In a tick it moves less than its diameter, so it would have to come
// near to the chain.
TEST(OnewayChainTest, ABallThatCameFromAboveNeverSinks) {
  properties::forEachCase(step_check::runLength(150, 10000), [](RandomSource& random) {
    const Chain chain(random);
    PlayedGame played(cubeLevel("0 0 150 0", {chain.text() + "-225 -200 -225 200\n225 -200 225 200\n"}));
    std::uint8_t buttons = kNone;
    int grounded = 0;
    for (int tick = 0; tick < 900; ++tick) {
      if (random.oneIn(12)) {
        buttons = random.oneIn(2) ? Input::kLeft : Input::kRight;
        if (random.oneIn(3)) buttons |= Input::kJump;
        if (random.oneIn(4)) buttons = kNone;
        if (random.oneIn(6)) buttons |= Input::kDown;
      }
      played.run(1, buttons);
      grounded += played.grounded() ? 1 : 0;
      ASSERT_GE(chain.distance(played.position()), kPlayerApothem - kOnewaySlack) << "tick " << tick;
    }
    ASSERT_GT(grounded, 100);
  });
}

}  // namespace
}  // namespace platon::long_runs::element_floors_test
