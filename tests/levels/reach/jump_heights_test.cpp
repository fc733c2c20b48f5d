#include "levels/reach/jump_heights.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/shared/game/played_game.h"
#include "tests/sim/button_presses.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"

namespace platon::jump_heights_test {
namespace {

constexpr std::uint64_t kSeed = 11;

const std::string kFlat = "-240 -200 240 -200\n";
const std::string kRoom = "60 -200 60 -20 door 1\n60 -20 240 -20\n240 -20 240 -200\n";

bool reachesGoal(const std::string& segments, const std::string& goal) {
  return JumpHeights(*cubeLevel("0 0 -180 0", {kFlat + segments, kFlat, kFlat, kFlat}, goal), {}).reachesGoal();
}

TEST(JumpHeightsTest, AGoalOnTheFloorIsReached) { EXPECT_TRUE(reachesGoal("", "0 100 -184")); }

TEST(JumpHeightsTest, AGoalInABoxIsNotReached) {
  EXPECT_FALSE(reachesGoal("50 -150 150 -150\n150 -150 150 -50\n150 -50 50 -50\n50 -50 50 -150", "0 100 -100"));
}

TEST(JumpHeightsTest, AnyNumberOfCrossingsIsAllowed) { EXPECT_TRUE(reachesGoal("", "2 0 -184")); }

TEST(JumpHeightsTest, ADoorIsNoWayWithoutItsKey) {
  EXPECT_FALSE(reachesGoal(kRoom, "0 160 -184"));
  EXPECT_FALSE(reachesGoal(kRoom + "-100 -180 -100 -160 key 2", "0 160 -184"));
  EXPECT_TRUE(reachesGoal(kRoom + "-100 -180 -100 -160 key 1", "0 160 -184"));
  const auto level = cubeLevel("0 0 -180 0", {kFlat + kRoom, kFlat, kFlat, kFlat}, "0 160 -184");
  EXPECT_TRUE(JumpHeights(*level, {.allDoorsOpen = true}).reachesGoal());
}

TEST(JumpHeightsTest, WhatIsNotTouchedOpensNothing) {
  const std::string opened = kFlat + kRoom + "-100 -180 -100 -160 key 1\n-60 -200 -20 -200 plate 1\n";
  const auto level = cubeLevel("0 0 -180 0", {opened, kFlat, kFlat, kFlat}, "0 160 -184");
  const ElementWord key{ElementKind::kKey, 1};
  const ElementWord plate{ElementKind::kPlate, 1};
  EXPECT_TRUE(JumpHeights(*level, {.without = {key}}).reachesGoal());
  EXPECT_TRUE(JumpHeights(*level, {.without = {plate}}).reachesGoal());
  EXPECT_FALSE(JumpHeights(*level, {.without = {key, plate}}).reachesGoal());
}

// A checkpoint that reaches through a wall, and a hazard that brings the player to its middle.
TEST(JumpHeightsTest, ACheckpointAndAHazardLeadThroughAWall) {
  const std::string wall = "60 -200 60 0\n60 0 240 0\n240 0 240 -200\n";
  const std::string checkpoint = "20 -180 220 -180 checkpoint\n";
  EXPECT_FALSE(reachesGoal(wall + checkpoint, "0 160 -150"));
  EXPECT_TRUE(reachesGoal(wall + checkpoint + "-100 -200 -60 -200 hazard", "0 160 -150"));
  const auto level = cubeLevel(
      "0 0 -180 0", {kFlat + wall + checkpoint + "-100 -200 -60 -200 hazard", kFlat, kFlat, kFlat}, "0 160 -150");
  EXPECT_FALSE(JumpHeights(*level, {.without = {{ElementKind::kCheckpoint}}}).reachesGoal());
}

// Cells grow with the face, until a jump rises by less than one of them.
TEST(JumpHeightsTest, AJumpReachesItsGoalOnALargeFace) {
  const std::string room = "-900 -2000 900 -2000\n-900 -1100 900 -1100\n-900 -2000 -900 -1100\n900 -2000 900 -1100\n";
  const auto level = levelOf("HEXAHEDRON\n0 0 -1988 0\n0 300 -1905\n20000\n%\n" + room + "%\n%\n%\n%\n%\n");
  EXPECT_TRUE(JumpHeights(*level, {}).reachesGoal());
}

TEST(JumpHeightsTest, AStoppedSearchSaysSo) {
  const auto level = cubeLevel("0 0 -180 0", {kFlat}, "0 100 -184");
  EXPECT_TRUE(JumpHeights(*level, {.stop = [] { return true; }}).isStopped());
  EXPECT_FALSE(JumpHeights(*level, {.stop = [] { return false; }}).isStopped());
}

TEST(JumpHeightsTest, ARandomPlayerIsOnlyWhereItMayBe) {
  const std::vector<std::string> files = shippedLevels();
  for (std::size_t i = 0; i < files.size(); i += isBrief() ? 5 : 1) {
    const std::string& file = files[i];
    const auto level = levelOf(readText(file));
    const JumpHeights heights(*level, {});
    EXPECT_TRUE(heights.reachesGoal()) << file;
    for (std::uint32_t play = 0; play < repetitions(2u); ++play) {
      Game game(level);
      sim::ButtonPresses presses(kSeed, play);
      for (int tick = 0; tick < 1500; ++tick) {
        const Input inputs[] = {presses.next()};
        game.advance(inputs);
        const EntityState& player = game.world().entities()[0];
        ASSERT_TRUE(heights.reaches(player.part, player.position)) << file << ", seed " << kSeed << ", play " << play;
      }
    }
  }
}

}  // namespace
}  // namespace platon::jump_heights_test
