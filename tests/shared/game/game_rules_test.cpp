#include "shared/game/game_rules.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "platon/game/solid.h"
#include "tests/shared/game/played_elements.h"

namespace platon::game_rules_test {
namespace {

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

TEST(GameRulesTest, ATimedSegmentLetsPassByTheClockOfTheRound) {
  PlayedGame played = playedOn("60 -200 60 -100 timed 90 60");
  while (played.game.tick() < 90) played.run(1, Input::kRight);
  EXPECT_EQ(played.position().x, units(60) - kPlayerApothem);
  played.run(1, Input::kRight);
  EXPECT_GT(played.position().x, units(60) - kPlayerApothem);
  played.run(20, Input::kRight);
  EXPECT_GT(played.position().x, units(60) + kPlayerApothem);
}

TEST(GameRulesTest, ATimedSegmentThatClosesOnAPlayerLetsItOut) {
  PlayedGame played = playedOn("60 -200 60 -100 timed 90 3");
  while (played.game.tick() < 94) played.run(1, Input::kRight);
  ASSERT_FALSE(played.game.open().has(played.game.level().elements[0]));
  ASSERT_LT(std::abs(played.position().x - units(60)), kPlayerApothem) << "the player is in the segment";
  played.run(30, Input::kRight);
  EXPECT_GT(played.position().x, units(72));
  played.run(40, Input::kLeft);
  EXPECT_EQ(played.position().x, units(60) + kPlayerApothem) << "behind it, it is solid";
}

TEST(GameRulesTest, ARestartDoesNotSetTheClockBack) {
  PlayedGame played = playedOn("60 -200 60 -100 timed 90 60");
  played.run(50, kNone);
  played.run(1, Input::kRestart);
  while (played.game.tick() < 90) played.run(1, kNone);
  EXPECT_TRUE(played.game.open().has(played.game.level().elements[0]));
}

TEST(GameRulesTest, ElementsAreSavedHashedAndRestored) {
  PlayedGame played = playedOn(
      "40 -180 40 -160 key 0\n80 -200 80 -100 door 0\n-40 -180 -40 -160 checkpoint\n120 -200 160 -200 plate 2\n"
      "-240 -150 -100 -150 timed 7 5");
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

TEST(GameRulesTest, EveryPlayerReturnsToItsOwnCheckpoint) {
  PlayedGame played = playedOn("-60 -180 -60 -160 checkpoint\n60 -180 60 -160 checkpoint\n-120 -200 -120 -150 hazard");
  played.hold(1, Input::kLeft);
  played.run(25, Input::kRight);
  EXPECT_EQ(played.player(0).checkpoint, 2);
  EXPECT_EQ(played.player(1).checkpoint, 1);
  for (int tick = 0; tick < 60 && played.player(1).velocity != Point(); ++tick) played.run(1, kNone);
  EXPECT_EQ(played.entity(1).position, Point(units(-60), units(-170)));
}

// The checkpoint is on the right face; the player touches it with its centre still on the first one.
TEST(GameRulesTest, ACheckpointIsTouchedOverAnEdge) {
  PlayedGame played(cubeLevel("4 228 0 90", {"", "0 239 0 190 checkpoint"}));
  played.run(1, kNone);
  for (int tick = 0; tick < 30 && played.player().checkpoint == 0; ++tick) played.run(1, kNone);
  ASSERT_EQ(played.player().checkpoint, 1);
  ASSERT_EQ(played.entity().part, 4u);
  EXPECT_EQ(played.player().checkpointUp,
            Angle::degrees(90) + PlatonicSolid::of(SolidKind::kHexahedron).neighbour(4, 1).turn);
}

TEST(GameRulesTest, TwoPlayersAtAHazardReturnInOneTick) {
  PlayedGame played(cubeLevel("0 0 -100 0", {"-240 -150 240 -150 hazard"}));
  played.hold(1, Input::kRight);
  played.run(1, Input::kRight);
  while (played.player(0).velocity != Point() && played.game.tick() < 100) played.run(1, Input::kRight);
  ASSERT_LT(played.game.tick(), 100u);
  for (const std::uint32_t slot : {0U, 1U}) EXPECT_EQ(played.entity(slot).position, Point(0, units(-100))) << slot;
}

TEST(GameRulesTest, GamesWithOtherKeysDiffer) {
  const std::string lines = "-40 -180 -40 -160 key 1\n-50 -180 -50 -160 key 2";
  PlayedGame played = playedOn(lines);
  played.run(8, Input::kLeft);
  while (played.game.openDoors() == 0) played.run(1, Input::kLeft);
  const std::vector<std::uint8_t> saved = played.game.save();
  int refused = 0;
  int restored = 0;
  for (std::size_t byte = 0; byte < saved.size(); ++byte) {
    std::vector<std::uint8_t> changed = saved;
    changed[byte] ^= 4;
    Game other(played.game.sharedLevel());
    const bool accepted = other.restore(changed);
    refused += accepted ? 0 : 1;
    if (!accepted || other.openDoors() == played.game.openDoors()) continue;
    ++restored;
    EXPECT_FALSE(other == played.game) << byte;
    EXPECT_NE(other.hash(), played.game.hash()) << byte;
  }
  EXPECT_EQ(restored, 2) << "a key and a plate";
  EXPECT_GT(refused, 0);
}

TEST(GameRulesTest, StatesThatTheLevelCannotHaveAreRefused) {
  PlayedGame played = playedOn("-40 -180 -40 -160 checkpoint\n60 -180 60 -160 key 1\n100 -180 100 -160 hazard");
  played.run(20, Input::kLeft);
  ASSERT_EQ(played.player().checkpoint, 1);
  const std::vector<std::uint8_t> saved = played.game.save();
  std::set<std::uint32_t> doors;
  std::set<std::uint16_t> checkpoints;
  for (std::size_t byte = 0; byte < saved.size(); ++byte) {
    for (int value = 0; value < 8; ++value) {
      std::vector<std::uint8_t> changed = saved;
      changed[byte] = static_cast<std::uint8_t>(value);
      Game other(played.game.sharedLevel());
      if (!other.restore(changed)) continue;
      doors.insert(other.openDoors());
      checkpoints.insert(other.player(0).checkpoint);
    }
  }
  EXPECT_EQ(doors, (std::set<std::uint32_t>{0, 2}));
  EXPECT_EQ(checkpoints, (std::set<std::uint16_t>{0, 1}));
}

TEST(GameRulesTest, TheLastPlayerToLeaveClosesTheDoors) {
  PlayedGame played = playedOn("40 -180 40 -160 key 0");
  played.hold(1, kNone);
  played.run(20, Input::kRight);
  ASSERT_EQ(played.game.openDoors(), 1u);
  played.release(0);
  played.advance();
  EXPECT_EQ(played.game.openDoors(), 0u) << "the other player has not begun";
}

}  // namespace
}  // namespace platon::game_rules_test
