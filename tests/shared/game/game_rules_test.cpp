#include "shared/game/game_rules.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/shared/game/played_game.h"

namespace platon {
namespace {

const std::string kFlat = "-240 -200 240 -200\n";
constexpr std::int32_t kStanding = units(-200) + kPlayerApothem;

PlayedGame playedOn(const std::string& lines, const std::string& start = "0 0 -180 0") {
  PlayedGame played(cubeLevel(start, {kFlat + lines}));
  played.run(30, kNone);
  return played;
}

std::int32_t peakOfJump(PlayedGame& played) {
  std::int32_t peak = played.position().y;
  for (int tick = 0; tick < 50; ++tick) {
    played.run(1, Input::kJump);
    peak = std::max(peak, played.position().y);
  }
  return peak;
}

TEST(GameRulesTest, AOnewaySegmentBlocksFromItsLeftSideOnly) {
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
TEST(GameRulesTest, APlayerThatTurnsRoundInAOnewaySegmentFallsBack) {
  PlayedGame played = playedOn("-100 -135 100 -135 oneway");
  const std::int32_t peak = peakOfJump(played);
  EXPECT_GT(peak + kPlayerApothem, units(-135));
  EXPECT_LT(peak - kPlayerApothem, units(-135));
  played.run(60, kNone);
  EXPECT_EQ(played.position().y, kStanding);
}

// The floor is one subunit higher or lower than the one-way segment that continues it, on a slope rounded as it comes.
TEST(GameRulesTest, APlayerRunsFromAFloorOntoAOnewaySegment) {
  for (const char* lines :
       {"-240 -100 0 -100\n0 -100 240 -100 oneway", "-240 -100 0 -100\n0 -100.001 240 -100 oneway",
        "-240 -100 0 -99.999\n0 -100 240 -100 oneway", "-240 -150 0 -100.5\n0 -100.5 240 -51 oneway",
        "-240 -100 0 -100.5\n0 -100.5 237 -112 oneway"}) {
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
TEST(GameRulesTest, ACeilingDoesNotPressAPlayerThroughAOnewaySegment) {
  PlayedGame played(cubeLevel("0 -100 -130 0", {kFlat + "-240 -150 240 -150 oneway\n-200 -110 200 -128"}));
  played.run(60, kNone);
  const std::int32_t ground = units(-150) + kPlayerApothem;
  ASSERT_EQ(played.position().y, ground);
  for (int tick = 0; tick < 300; ++tick) {
    played.run(1, static_cast<std::uint8_t>(Input::kRight | (tick % 2 == 0 ? Input::kJump : kNone)));
    ASSERT_GE(played.position().y, ground - 1) << tick;
  }
}

TEST(GameRulesTest, AnUpSegmentBlocksOnlyPlayersWhoseUpPointsToItsEdge) {
  // Edge 2 is at the top of the first face.
  for (int edge = 0; edge < 4; ++edge) {
    PlayedGame played = playedOn("-100 -150 100 -150 up " + std::to_string(edge));
    const bool blocks = edge == 2;
    EXPECT_EQ(peakOfJump(played), blocks ? units(-150) - kPlayerApothem : kStanding + 61350) << edge;
  }
}

// Half an edge's angle belongs to the edge; of two edges at the same angle, the one that is clockwise of up.
TEST(GameRulesTest, EveryUpPointsToOneEdge) {
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

TEST(GameRulesTest, AHazardBlocksAndSendsThePlayerToTheStart) {
  PlayedGame played = playedOn("60 -200 60 -150 hazard");
  const Point rest = played.position();
  std::int32_t farthest = 0;
  for (int tick = 0; tick < 60; ++tick) {
    played.run(1, Input::kRight);
    farthest = std::max(farthest, played.position().x);
    if (farthest > 0 && played.position().x < farthest) break;
  }
  EXPECT_LE(farthest, units(60) - kPlayerApothem);
  EXPECT_GT(farthest, units(40));
  EXPECT_EQ(played.position(), Point(0, units(-180)));
  EXPECT_EQ(played.player().velocity, Point());
  EXPECT_NE(played.player().startedAt, 0u) << "the attempt goes on";
  played.run(60, kNone);
  EXPECT_EQ(played.position(), rest);
}

TEST(GameRulesTest, AHazardSendsThePlayerToItsLastCheckpointWithTheUpOfThen) {
  PlayedGame played = playedOn("40 -180 40 -160 checkpoint\n120 -200 120 -150 hazard");
  while (played.player().checkpoint == 0 && played.game.tick() < 100) played.run(1, Input::kRight);
  EXPECT_EQ(played.player().checkpoint, 1);
  EXPECT_EQ(played.player().checkpointUp, Angle());
  std::int32_t farthest = 0;
  while (played.position().x >= farthest && played.game.tick() < 200) {
    farthest = played.position().x;
    played.run(1, Input::kRight);
  }
  EXPECT_EQ(played.position(), Point(units(40), units(-170)));
  played.run(1, Input::kRestart);
  EXPECT_EQ(played.player().checkpoint, 0) << "a restart goes to the start";
  EXPECT_EQ(played.position().x, 0);
}

TEST(GameRulesTest, AKeyOpensItsDoorsForEverybody) {
  PlayedGame played = playedOn("-60 -180 -60 -160 key 3\n60 -200 60 -100 door 3\n100 -200 100 -100 door 4");
  played.hold(1, kNone);
  played.run(60, Input::kRight);
  EXPECT_EQ(played.position().x, units(60) - kPlayerApothem) << "the door is closed";
  played.run(60, Input::kLeft);
  EXPECT_EQ(played.game.openDoors(), 1u << 3);
  EXPECT_TRUE(played.game.isTaken(played.game.level().elements[0]));
  played.hold(1, Input::kRight);
  played.run(60, kNone);
  EXPECT_EQ(played.entity(1).position.x, units(100) - kPlayerApothem) << "the other player passes door 3, not door 4";
}

TEST(GameRulesTest, ARestartAloneClosesTheDoors) {
  PlayedGame played = playedOn("40 -180 40 -160 key 0\n80 -200 80 -100 door 0");
  played.run(20, Input::kRight);
  EXPECT_EQ(played.game.openDoors(), 1u);
  played.run(1, Input::kRestart);
  EXPECT_EQ(played.game.openDoors(), 0u);
  played.run(1, kNone);
  EXPECT_EQ(played.game.openDoors(), 0u);
}

// The time of a level with keys is that of all players, so that nobody gets a short time through an open door.
TEST(GameRulesTest, WhoBeginsAfterAnotherPlayerIsTimedFromTheSameTick) {
  PlayedGame played = playedOn("40 -180 40 -160 key 0\n80 -200 80 -100 door 0");
  played.run(20, Input::kRight);
  const std::uint32_t first = played.player(0).startedAt;
  played.hold(1, Input::kRight);
  played.run(5, kNone);
  EXPECT_EQ(played.player(1).startedAt, first);
  played.run(1, Input::kRestart);
  EXPECT_EQ(played.game.openDoors(), 1u) << "the other player is under way";
  played.run(5, Input::kRight);
  EXPECT_EQ(played.player(0).startedAt, first);
  played.release(1);
  played.run(1, Input::kRestart);
  played.run(1, Input::kRight);
  EXPECT_EQ(played.player(0).startedAt, played.game.tick()) << "alone, everything begins again";
  EXPECT_EQ(played.game.openDoors(), 0u);
}

TEST(GameRulesTest, APlateOpensItsDoorsWhileAPlayerStandsOnIt) {
  PlayedGame played = playedOn("-40 -200 40 -200 plate 1\n100 -200 100 -100 door 1");
  EXPECT_EQ(played.game.openDoors(), 2u);
  for (int tick = 0; tick < 1000; ++tick) {
    played.run(1, kNone);
    ASSERT_EQ(played.game.openDoors(), 2u) << tick;
  }
  played.run(25, Input::kRight);
  EXPECT_EQ(played.game.openDoors(), 0u) << "the player has left it";
  played.run(60, Input::kRight);
  EXPECT_EQ(played.position().x, units(100) - kPlayerApothem);
  played.hold(1, kNone);
  played.run(30, kNone);
  played.run(20, Input::kRight);
  EXPECT_GT(played.position().x, units(100)) << "another player stands on it";
}

TEST(GameRulesTest, APlateIsNotPressedFromBelow) {
  PlayedGame played = playedOn("-100 -150 100 -150 plate 1");
  for (int tick = 0; tick < 60; ++tick) {
    played.run(1, Input::kJump);
    EXPECT_EQ(played.game.openDoors(), 0u);
  }
}

TEST(GameRulesTest, ADoorThatClosesOnAPlayerLetsItOut) {
  PlayedGame played = playedOn("-40 -200 40 -200 plate 1\n60 -200 60 -100 door 1");
  played.hold(1, kNone);
  played.run(10, kNone);
  while (played.position().x < units(58) && played.game.tick() < 200) played.run(1, Input::kRight);
  played.hold(1, Input::kLeft | Input::kJump);
  played.run(25, kNone);
  ASSERT_EQ(played.game.openDoors(), 0u);
  ASSERT_LT(std::abs(played.position().x - units(60)), kPlayerApothem) << "the player is in the door";
  played.run(30, Input::kRight);
  EXPECT_GT(played.position().x, units(72));
  played.run(40, Input::kLeft);
  EXPECT_EQ(played.position().x, units(60) + kPlayerApothem) << "behind it the door is closed";
}

TEST(GameRulesTest, ElementsAreSavedHashedAndRestored) {
  PlayedGame played = playedOn(
      "40 -180 40 -160 key 0\n80 -200 80 -100 door 0\n-40 -180 -40 -160 checkpoint\n120 -200 160 -200 plate 2");
  played.hold(1, kNone);
  played.run(15, Input::kLeft);
  while (played.game.openDoors() != 5u && played.game.tick() < 200) played.run(1, Input::kRight);
  ASSERT_EQ(played.game.openDoors(), 5u);
  ASSERT_EQ(played.player().checkpoint, 3);
  Game restored(played.game.sharedLevel());
  ASSERT_TRUE(restored.restore(played.game.save()));
  EXPECT_EQ(restored, played.game);
  EXPECT_EQ(restored.hash(), played.game.hash());
  const std::vector<Input> inputs = {Input{Input::kPresent | Input::kLeft}, Input{Input::kPresent | Input::kRight}};
  for (int tick = 0; tick < 200; ++tick) {
    played.game.advance(inputs);
    restored.advance(inputs);
    ASSERT_EQ(restored.hash(), played.game.hash()) << tick;
  }
}

}  // namespace
}  // namespace platon
