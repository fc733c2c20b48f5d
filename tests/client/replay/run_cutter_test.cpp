#include "client/replay/run_cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "client/replay/run_track.h"
#include "platon/game/recording_reader.h"
#include "tests/client/replay/crowded_door_level.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/replay_of.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"

namespace platon::run_cutter_test {
namespace {

// The goal is on the floor to the right of the start.
std::shared_ptr<const Level> floorLevel() { return cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190"); }

// A door between start and goal, and its key on the other side.
std::shared_ptr<const Level> doorLevel() {
  return cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n60 -200 60 200 door 1\n-60 -200 -60 -150 key 1"}, "0 150 -190");
}

std::vector<std::vector<Input>> inputsOf(const std::vector<std::uint8_t>& recording) {
  RecordingReader reader(recording);
  std::vector<std::vector<Input>> inputs;
  while (const auto block = reader.next()) {
    for (std::uint32_t i = 0; i < block->ticks(); ++i) {
      const auto tick = block->inputsOf(i);
      inputs.emplace_back(tick.begin(), tick.end());
    }
  }
  return inputs;
}

std::uint32_t slotsOf(const Replay& replay) { return replay.gameAfter(replay.ticks()).slots(); }

void expectSameRun(const FollowedGame& followed) {
  ASSERT_TRUE(followed.time && followed.run);
  EXPECT_EQ(followed.run->ticks, *followed.time);
  const auto track = trackOf(*replayOf(followed.run->recording));
  ASSERT_TRUE(track);
  EXPECT_EQ(track->ticks, *followed.time);
}

class EveryWay : public testing::TestWithParam<std::string> {};

// The run of each player of each recorded way ends where the player was, after as many ticks.
TEST_P(EveryWay, IsCut) {
  const auto recording = readBytes(GetParam());
  const auto level = RecordingReader(recording).level();
  ASSERT_TRUE(level);
  const auto inputs = inputsOf(recording);
  std::uint32_t runs = 0;
  for (std::uint32_t slot = 0; slot < inputs.back().size(); ++slot) {
    FollowedGame followed(level, slot);
    std::optional<Place> goal;
    for (const auto& tick : inputs) {
      const bool before = followed.time.has_value();
      followed.advance(tick);
      if (followed.time && !before) {
        goal = Place{followed.game.world().entities()[slot].part, followed.game.world().entities()[slot].position};
      }
    }
    if (!goal) continue;
    ++runs;
    expectSameRun(followed);
    const PlayerSnapshot last = trackOf(*replayOf(followed.run->recording))->places.back();
    EXPECT_EQ(last.part, goal->part);
    EXPECT_EQ(last.position, goal->position);
  }
  EXPECT_GT(runs, 0U);
}

INSTANTIATE_TEST_SUITE_P(All, EveryWay, testing::ValuesIn(filesIn("levels/data/ways", ".recording")),
                         [](const auto& file) { return "way_" + std::filesystem::path(file.param).stem().string(); });

TEST(RunCutter, ARunBeginsWithAFreshGameOfOnePlayer) {
  FollowedGame followed(floorLevel(), 2);
  const Input other{Input::kPresent | Input::kJump};
  const auto at = [](std::uint8_t buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; };
  for (int i = 0; i < 30; ++i) followed.advance({other, other});
  for (int i = 0; i < 30; ++i) followed.advance({other, other, at(0)});
  for (int i = 0; i < 200; ++i) followed.advance({other, other, at(Input::kRight)});
  expectSameRun(followed);
  const auto replay = replayOf(followed.run->recording);
  EXPECT_EQ(replay->gameAfter(0).tick(), 0U);
  EXPECT_EQ(slotsOf(*replay), 1U);
}

TEST(RunCutter, RestBeforeTheFirstInputIsLeftOut) {
  FollowedGame followed(floorLevel());
  followed.hold(2000, 0);
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
  EXPECT_LT(replayOf(followed.run->recording)->ticks(), *followed.time + 100);
}

TEST(RunCutter, EachAttemptIsARunOfItsOwn) {
  FollowedGame followed(floorLevel());
  followed.holdToGoal(200, Input::kRight | Input::kCreep);
  const std::uint32_t slow = *followed.time;
  followed.hold(50, 0);
  followed.hold(1, Input::kRestart);
  followed.hold(40, Input::kLeft);
  followed.hold(1, Input::kRestart | Input::kRight);
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
  EXPECT_LT(*followed.time, slow);
}

// Just above the floor a pressed button would be a jump, and a held one is none.
TEST(RunCutter, AButtonThatIsHeldAtTheRestartIsNotPressed) {
  FollowedGame followed(cubeLevel("0 0 -187 0", {"-240 -200 240 -200"}, "0 100 -190"));
  followed.hold(40, Input::kLeft | Input::kJump);
  followed.hold(1, Input::kRestart | Input::kJump);
  followed.holdToGoal(200, Input::kRight | Input::kJump);
  expectSameRun(followed);
}

TEST(RunCutter, WhoIsFoundAtRestHasARun) {
  FollowedGame followed(floorLevel());
  followed.hold(90, 0);
  followed.cutter.begin(followed.game, 0);
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
}

TEST(RunCutter, AnAttemptThatWasNotSeenFromItsFirstInputIsNone) {
  FollowedGame followed(floorLevel());
  followed.hold(5, Input::kRight);
  followed.cutter.begin(followed.game, 0);
  followed.holdToGoal(200, Input::kRight);
  ASSERT_TRUE(followed.time);
  EXPECT_FALSE(followed.run);
  followed.hold(1, Input::kRestart);
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
}

TEST(RunCutter, WhoHasOpenedTheDoorAloneHasARunAlone) {
  FollowedGame followed(doorLevel());
  followed.hold(60, Input::kLeft);
  followed.holdToGoal(300, Input::kRight);
  expectSameRun(followed);
  EXPECT_EQ(slotsOf(*replayOf(followed.run->recording)), 1U);
}

TEST(RunCutter, ARunWithTheHelpOfOthersHasAllPlayers) {
  FollowedGame followed(doorLevel(), 1);
  const auto at = [](std::uint8_t buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; };
  for (int i = 0; i < 400; ++i) followed.advance({at(0), at(0)});
  for (int i = 0; i < 60; ++i) followed.advance({at(Input::kLeft), at(0)});
  for (int i = 0; i < 200 && !followed.time; ++i) followed.advance({at(0), at(Input::kRight)});
  expectSameRun(followed);
  EXPECT_GT(*followed.time, 60U) << "counts from the first input of the other";
  const auto replay = replayOf(followed.run->recording);
  EXPECT_EQ(slotsOf(*replay), 2U);
  EXPECT_LE(replay->ticks(), *followed.time + 60);
}

// Alone from tick 0, it would come to the fence at another time.
TEST(RunCutter, ARunPastATimedSegmentKeepsTheClockOfTheRound) {
  FollowedGame followed(cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n60 -200 60 200 timed 50 50"}, "0 150 -190"));
  followed.hold(130, 0);
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
  const auto first = replayOf(followed.run->recording);
  EXPECT_EQ(first->gameAfter(first->ticks()).tick() % 100, followed.game.tick() % 100);
  followed.hold(37, Input::kLeft);
  followed.hold(1, Input::kRestart);
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
  const auto second = replayOf(followed.run->recording);
  EXPECT_EQ(second->gameAfter(second->ticks()).tick() % 100, followed.game.tick() % 100);
}

TEST(RunCutter, AGroupRunThatNobodyCouldReadIsNotCut) {
  const auto level = crowdedDoorLevel();
  const auto at = [](std::uint8_t buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; };
  for (const auto& [wait, affordable] : {std::pair(1000, true), std::pair(2500, false)}) {
    FollowedGame followed(level, 1);
    std::vector<Input> inputs(kMaxPlayers);
    inputs[0] = inputs[1] = at(0);
    for (int i = 0; i < 100; ++i) followed.advance(inputs);
    inputs[0] = at(Input::kLeft);
    for (int i = 0; i < wait; ++i) followed.advance(inputs);
    inputs[1] = at(Input::kRight);
    for (int i = 0; i < 200 && !followed.time; ++i) followed.advance(inputs);
    ASSERT_TRUE(followed.time) << wait;
    ASSERT_EQ(followed.run.has_value(), affordable) << wait;
    EXPECT_EQ(followed.cutter.isGroupTooCostly(), !affordable) << wait;
    if (affordable) expectSameRun(followed);
  }
}

// A server can send any state.
TEST(RunCutter, WhoIsFoundElsewhereThanAtTheStartHasNoRunBeforeARestart) {
  for (const auto& [level, x] : {std::pair(floorLevel(), 60), std::pair(doorLevel(), 80)}) {
    FollowedGame followed(level);
    followed.hold(30, 0);
    ForgedState state(followed.game);
    state.entities[0].position.x = units(x);
    followed.game = state.game();
    followed.cutter.begin(followed.game, 0);
    followed.hold(90, 0);  // longer than a group is followed at least
    followed.holdToGoal(200, Input::kRight);
    ASSERT_TRUE(followed.time);
    EXPECT_FALSE(followed.run);
    followed.hold(1, Input::kRestart);
    followed.hold(60, Input::kLeft);
    followed.holdToGoal(300, Input::kRight);
    expectSameRun(followed);
  }
}

TEST(RunCutter, WhoLeavesHasNoRun) {
  FollowedGame followed(floorLevel());
  followed.hold(10, Input::kRight);
  followed.advance({});
  followed.holdToGoal(200, Input::kRight);
  expectSameRun(followed);
  EXPECT_EQ(trackOf(*replayOf(followed.run->recording))->places.front().present, false) << "joins with the first input";
}

}  // namespace
}  // namespace platon::run_cutter_test
