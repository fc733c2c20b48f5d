#include "shared/game/element_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/shared/game/played_elements.h"
#include "tests/support/sample_word.h"

namespace platon::element_rules_test {
namespace {

std::int32_t peakOfJump(PlayedGame& played) {
  std::int32_t peak = played.position().y;
  for (int tick = 0; tick < 50; ++tick) {
    played.run(1, Input::kJump);
    peak = std::max(peak, played.position().y);
  }
  return peak;
}

TEST(ElementRulesTest, AOnewaySegmentBlocksFromItsLeftSideOnly) {
  PlayedGame upwards = playedOn("-100 -150 100 -150 oneway");  // its left is above
  peakOfJump(upwards);
  upwards.run(60, kNone);
  EXPECT_EQ(upwards.position().y, units(-150) + kPlayerApothem) << "the player jumps through it and lands on it";
  PlayedGame downwards = playedOn("100 -150 -100 -150 oneway");
  EXPECT_EQ(peakOfJump(downwards), units(-150) - kPlayerApothem) << "turned round, it is a ceiling";
  PlayedGame falling(cubeLevel("0 0 -100 0", {kFlat + "100 -150 -100 -150 oneway"}));
  falling.run(60, kNone);
  EXPECT_EQ(falling.position().y, kStanding) << "through which a player falls";
}

// The apex of a jump is within the segment: it stays open until the player has left it.
TEST(ElementRulesTest, APlayerThatTurnsRoundInAOnewaySegmentFallsBack) {
  PlayedGame played = playedOn("-100 -135 100 -135 oneway");
  const std::int32_t peak = peakOfJump(played);
  EXPECT_GT(peak + kPlayerApothem, units(-135));
  EXPECT_LT(peak - kPlayerApothem, units(-135));
  played.run(60, kNone);
  EXPECT_EQ(played.position().y, kStanding);
}

// The floor is one subunit higher or lower than the one-way segment that continues it, on a slope rounded as it comes.
TEST(ElementRulesTest, APlayerRunsFromAFloorOntoAOnewaySegment) {
  for (const char* lines :
       {"-240 -100 0 -100\n0 -100 240 -100 oneway", "-240 -100.001 0 -100.001\n0 -100 240 -100 oneway",
        "-240 -100 0 -100\n0 -100.001 240 -100 oneway", "-240 -100 0 -99.999\n0 -100 240 -100 oneway",
        "-240 -150 0 -100.5\n0 -100.5 240 -51 oneway", "-240 -100 0 -100.5\n0 -100.5 237 -112 oneway"}) {
    PlayedGame played(cubeLevel("0 -120 0 0", {lines}));
    played.run(60, kNone);
    ASSERT_TRUE(played.grounded()) << lines;
    for (int tick = 0; tick < 200 && played.position().x < units(200); ++tick) {
      played.run(1, Input::kRight);
      ASSERT_TRUE(played.grounded()) << lines << " at " << played.position().x;
    }
  }
}

// A player on a one-way segment under a sloping ceiling is pressed down by it, but not through the segment.
TEST(ElementRulesTest, ACeilingDoesNotPressAPlayerThroughAOnewaySegment) {
  PlayedGame played(cubeLevel("0 -100 -130 0", {kFlat + "-240 -150 240 -150 oneway\n-200 -110 200 -128"}));
  played.run(60, kNone);
  const std::int32_t ground = units(-150) + kPlayerApothem;
  ASSERT_EQ(played.position().y, ground);
  for (int tick = 0; tick < 300; ++tick) {
    played.run(1, static_cast<std::uint8_t>(Input::kRight | (tick % 2 == 0 ? Input::kJump : kNone)));
    ASSERT_GE(played.position().y, ground - 1) << tick;
  }
}

TEST(ElementRulesTest, AnUpSegmentBlocksOnlyPlayersWhoseUpPointsToItsEdge) {
  // Edge 2 is at the top of the first face.
  for (int edge = 0; edge < 4; ++edge) {
    PlayedGame played = playedOn("-100 -150 100 -150 up " + std::to_string(edge));
    const bool blocks = edge == 2;
    EXPECT_EQ(peakOfJump(played), blocks ? units(-150) - kPlayerApothem : kStanding + 61350) << edge;
  }
}

// Half an edge's angle belongs to the edge; of two edges at the same angle, the one that is counter-clockwise of up.
TEST(ElementRulesTest, EveryUpPointsToOneEdge) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    int blocking = 0;
    for (int edge = 0; edge < 4; ++edge) {
      const std::string box = "-200 -200 200 -200\n200 -200 200 200\n200 200 -200 200\n-200 200 -200 -200\n";
      const std::string cross = "-200 0 200 0 up " + std::to_string(edge) + "\n";
      PlayedGame played(cubeLevel("0 5 30 " + std::to_string(degrees), {box + cross}));
      played.run(200, kNone);
      const bool passed = played.position().y < 0;
      blocking += degrees < 75 && !passed;
    }
    if (degrees < 75) {
      EXPECT_EQ(blocking, 1) << degrees;
    }
  }
}

// Two slopes that meet at a top, with ends four subunits apart.
TEST(ElementRulesTest, APlayerRollsOverTheTopOfTwoOnewaySegments) {
  PlayedGame played(cubeLevel("0 -40 0 0", {"-80 -54.26 -13.001 -38.6592 oneway\n-13.001 -38.6553 60 -43.66 oneway"}));
  played.run(40, kNone);
  for (int tick = 0; tick < 60; ++tick) {
    played.run(1, Input::kRight | Input::kCreep);
    ASSERT_TRUE(played.grounded()) << tick << " at " << played.position().x;
  }
  EXPECT_GT(played.position().x, units(10));
}

// Whether a one-way segment from 0 0 to 100 000 0 blocks a player with its centre there.
bool onewayBlocks(Point centre) {
  const auto level = cubeLevel("0 0 0 0", {"-9 50 9 50 oneway"});
  Game game(level);
  game.advance(std::vector<Input>{Input{Input::kPresent}});
  World world = game.world();
  const SegmentRef segment{.part = 0, .index = 0, .ends = {{0, 0}, {100000, 0}}, .position = centre};
  return !ElementRules(*level, {}).pierce(Entity(world, 0), segment);
}

TEST(ElementRulesTest, AOnewaySegmentBlocksWhoIsWhollyOnItsLeft) {
  EXPECT_TRUE(onewayBlocks({50000, kPlayerApothem - 64}));
  EXPECT_FALSE(onewayBlocks({50000, kPlayerApothem - 65}));
  EXPECT_FALSE(onewayBlocks({50000, 0}));
  EXPECT_FALSE(onewayBlocks({50000, -kPlayerApothem}));
  EXPECT_TRUE(onewayBlocks({-90000, kPlayerApothem - 64})) << "beyond its ends, too";
  EXPECT_TRUE(onewayBlocks({190000, kPlayerApothem}));
  EXPECT_FALSE(onewayBlocks({-90000, kPlayerApothem - 65}));
}

TEST(ElementRulesTest, AOnewaySegmentBlocksWhoIsAboveItsEnd) {
  for (const bool first : {true, false}) {
    const auto aboveEnd = [&](std::int32_t beyond, std::int32_t beside) {
      return onewayBlocks({first ? -beyond : 100000 + beyond, beside});
    };
    EXPECT_TRUE(aboveEnd(8477, 8477)) << "at 45°, 11 988.3 away";
    EXPECT_FALSE(aboveEnd(8476, 8476));
    EXPECT_FALSE(aboveEnd(9001, 9000));
    EXPECT_FALSE(aboveEnd(8477, -8477));
    EXPECT_TRUE(aboveEnd(1000, 11950));
    EXPECT_FALSE(aboveEnd(1000, 11940));
  }
}

// Centidegrees from the +y of the face to the player's up. Edge 2 of a hexahedron's face is at the top.
TEST(ElementRulesTest, HalfAnEdgesAngleBelongsToTheEdge) {
  const auto level = cubeLevel("0 0 0 0", {"-9 50 9 50 up 0\n-9 60 9 60 up 1\n-9 70 9 70 up 2\n-9 80 9 80 up 3"});
  Game game(level);
  game.advance(std::vector<Input>{Input{Input::kPresent}});
  World world = game.world();
  const ElementRules rules(*level, {});
  for (const auto& [up, edge] : {std::pair(0, 2U), std::pair(4499, 2U), std::pair(4500, 3U), std::pair(9000, 3U),
                                 std::pair(13499, 3U), std::pair(13500, 0U), std::pair(22499, 0U), std::pair(22500, 1U),
                                 std::pair(31499, 1U), std::pair(31500, 2U), std::pair(35999, 2U)}) {
    for (std::uint32_t segment = 0; segment < 4; ++segment) {
      const SegmentRef ref{.part = 0, .index = segment, .ends = level->segments[0][segment], .toHome = Angle(-up)};
      EXPECT_EQ(rules.pierce(Entity(world, 0), ref), segment != edge) << up << " " << segment;
    }
  }
}

TEST(ElementRulesTest, ALevelWithoutElementsAsksForContactsOnly) {
  EXPECT_EQ(ElementRules(*cubeLevel("0 0 0 0", {kFlat}), {}).scope(), Rules::Scope::kContacts);
  EXPECT_EQ(ElementRules(*cubeLevel("0 0 0 0", {kFlat, "", "0 0 9 9 hazard"}), {}).scope(), Rules::Scope::kSegments);
}

TEST(ElementRulesTest, OnlyWhatCanLetAPlayerPassIsAskedFor) {
  const auto level = cubeLevel(
      "0 0 0 0", {"-9 50 9 50 hazard\n-9 60 9 60 plate 1\n-9 70 9 70 oneway\n-9 80 9 80 up 1\n"
                  "-9 90 9 90 key 1\n-109 100 -91 100 checkpoint\n-9 110 9 110 door 1\n-9 120 9 120 timed 1 1\n"
                  "0 150 9 150"});
  const ElementRules rules(*level, {});
  for (std::uint32_t segment = 0; segment < 9; ++segment)
    EXPECT_EQ(rules.mayPierce(0, segment), segment >= 2 && segment < 8) << segment;
  EXPECT_FALSE(rules.mayPierce(1, 3));
}

// A segment of each kind at y = 50, with the doors open and closed, at two times, and a player of each up on both of
// its sides.
TEST(ElementRulesTest, EveryKindBlocksWhomItsTraitsName) {
  for (const ElementKind kind : kElementKinds) {
    const std::string word = sampleWord(kind).text();
    const auto level = cubeLevel("0 0 0 0", {"-9 50 9 50 " + word});
    Game game(level);
    game.advance(std::vector<Input>{Input{Input::kPresent}});
    World world = game.world();
    std::set<bool> answers;
    for (const OpenElements open : {OpenElements{0, 0}, OpenElements{~0U, 10}}) {
      for (const std::int32_t degrees : {0, 90, 180, 270}) {
        for (const std::int32_t y : {units(20), units(80)}) {
          const SegmentRef segment{
              .part = 0, .ends = level->segments[0][0], .toHome = Angle::degrees(degrees), .position = {0, y}};
          answers.insert(ElementRules(*level, open).pierce(Entity(world, 0), segment));
        }
      }
    }
    SCOPED_TRACE(
        "Rules::pierce for '" + word +
        "', with the doors open and closed at two times, the up of the player towards each side, and the player "
        "on both sides of the segment; if the kind depends on more, vary it here");
    switch (traitsOf(kind).blocking) {
      case ElementBlocking::kNobody:
        EXPECT_EQ(answers, std::set{true});
        break;
      case ElementBlocking::kSome:
        EXPECT_EQ(answers, (std::set{true, false}));
        break;
      case ElementBlocking::kEverybody:
        EXPECT_EQ(answers, std::set{false});
    }
  }
}

TEST(ElementRulesTest, ADoorBlocksUnlessItsNumberIsOpen) {
  const auto level = cubeLevel("0 0 0 0", {"-9 50 9 50 door 3\n-9 60 9 60 door 31\n-9 70 9 70"});
  Game game(level);
  game.advance(std::vector<Input>{Input{Input::kPresent}});
  World world = game.world();
  const Entity player(world, 0);
  for (const std::uint32_t open : {0U, 1U << 3, 1U << 31, ~0U}) {
    const ElementRules rules(*level, {open});
    const auto pierces = [&](std::uint32_t segment) {
      return rules.pierce(player, SegmentRef{.part = 0, .index = segment, .ends = level->segments[0][segment]});
    };
    EXPECT_EQ(pierces(0), (open >> 3 & 1U) != 0) << open;
    EXPECT_EQ(pierces(1), (open >> 31 & 1U) != 0) << open;
    EXPECT_FALSE(pierces(2)) << "no element";
  }
}

TEST(ElementRulesTest, ATimedSegmentBlocksByTheClockOfTheRound) {
  const auto level = cubeLevel("0 0 0 0", {"-9 50 9 50 timed 3 2"});
  Game game(level);
  game.advance(std::vector<Input>{Input{Input::kPresent}});
  World world = game.world();
  const SegmentRef segment{.part = 0, .index = 0, .ends = level->segments[0][0]};
  for (std::uint32_t tick = 0; tick < 20; ++tick)
    EXPECT_EQ(ElementRules(*level, {~0U, tick}).pierce(Entity(world, 0), segment), tick % 5 >= 3) << tick;
}

}  // namespace
}  // namespace platon::element_rules_test
