#include "client/demo/demo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/lobby/shipped_levels.h"
#include "tests/support/files.h"
#include "tests/support/sample_word.h"
#include "tests/support/test_levels.h"

namespace platon::demo_test {
namespace {

TEST(GoalDistance, IsSmallAtTheGoalAndGrowsWithDistance) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  const auto unit = kSubunitsPerUnit;
  EXPECT_LT(distance.from({level->goalFace, level->goal}), 20 * unit);
  const std::int32_t fromStart = distance.from({level->startFace, level->start});
  EXPECT_GT(fromStart, 300 * unit);
  EXPECT_LT(fromStart, 360 * unit);
}

TEST(GoalDistance, CrossesEdgesButNotSegments) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  for (const std::uint32_t face : {1u, 2u, 3u, 4u}) {
    const std::int32_t value = distance.from({face, Point(0, 0)});
    EXPECT_GT(value, 240 * kSubunitsPerUnit) << "face " << face;
    EXPECT_LT(value, 1200 * kSubunitsPerUnit) << "face " << face;
  }
  EXPECT_EQ(distance.from({5, Point(0, 0)}), GoalDistance::kUnreachable);
}

// Along a straight path across the floor from the start, the distance decreases towards the goal.
TEST(GoalDistance, DecreasesTowardsTheGoal) {
  const auto level = flatLevel();
  GoalDistance distance(*level);
  std::int32_t last = distance.from({level->goalFace, level->start});
  for (std::int32_t x = -100; x <= 100; x += 50) {
    const std::int32_t next = distance.from({level->goalFace, Point(x * kSubunitsPerUnit, level->start.y)});
    EXPECT_LT(next, last) << x;
    last = next;
  }
}

// A level of the cube with this start, goal and walls on face 0; a line of its own for each.
std::shared_ptr<const Level> roomOf(const std::string& start, const std::string& goal, const std::string& walls) {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n0 " + start + " 0\n0 " + goal + "\n480\n%\n" + walls + "%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

// A room on face 0, from x = -220 to 220 and from y = -200 to -100, with the goal at its right end.
std::shared_ptr<const Level> roomWith(const std::string& segments) {
  return roomOf("-150 -180", "160 -180",
                "-220 -200 220 -200\n220 -200 220 -100\n220 -100 -220 -100\n-220 -100 -220 -200\n" + segments + "\n");
}

std::int32_t fromStart(const std::string& segments, std::uint32_t open = 0) {
  const auto level = roomWith(segments);
  return GoalDistance(*level).from({level->startFace, level->start}, open);
}

TEST(GoalDistance, ElementsThatCanBePassedAreNotInTheWay) {
  const std::int32_t plain = fromStart("");
  EXPECT_LT(plain, 360 * kSubunitsPerUnit);
  // The left of a segment that leads down is on the right.
  for (const char* wall : {"0 -100 0 -200 oneway", "0 -200 0 -100 up 1", "0 -200 0 -100 checkpoint"})
    EXPECT_EQ(fromStart(wall), plain) << wall;
}

TEST(GoalDistance, HazardsPlatesAndClosedDoorsAreInTheWay) {
  for (const char* wall : {"0 -200 0 -100", "0 -200 0 -100 hazard", "0 -200 0 -100 plate 3", "0 -200 0 -100 door 3",
                           "0 -200 0 -100 oneway"}) {
    EXPECT_EQ(fromStart(wall), GoalDistance::kUnreachable) << wall;
  }
  EXPECT_EQ(fromStart("0 -200 0 -100 door 3", 1u << 3), fromStart(""));
  EXPECT_EQ(fromStart("0 -200 0 -100 door 3", 1u << 2), GoalDistance::kUnreachable);
}

// Each kind with some numbers, the doors closed and open, and the player on either side. The demonstration takes the
// way through every `up`, and waits at no timed segment.
TEST(GoalDistance, WhatBlocksSomeIsInTheWayAtTimes) {
  const std::int32_t plain = fromStart("");
  for (const ElementKind kind : kElementKinds) {
    SCOPED_TRACE("Obstacles::block in client/demo/demo.cpp, for '" + std::string(wordOf(kind)) + "'");
    int free = 0;
    int blocked = 0;
    for (std::uint8_t number = 0; number < 4; ++number) {
      for (const char* ends : {"0 -200 0 -100 ", "0 -100 0 -200 "}) {
        for (const std::uint32_t open : {0U, ~0U}) {
          const std::int32_t distance = fromStart(ends + sampleWord(kind, number).text(), open);
          free += distance == plain ? 1 : 0;
          blocked += distance == GoalDistance::kUnreachable ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(free + blocked, 16);
    EXPECT_EQ(free > 0, !blocksAlways(kind));
    EXPECT_EQ(blocked > 0, canBlock(kind) && kind != ElementKind::kUp && kind != ElementKind::kTimed);
  }
}

// The way to the key and from there through the door, until the key is taken.
TEST(GoalDistance, AKeyIsOnTheWayToItsDoor) {
  const std::string segments = "0 -200 0 -100 door 3\n-200 -180 -200 -160 key 3";
  const std::int32_t plain = fromStart("");
  const std::int32_t withKey = fromStart(segments);
  EXPECT_GT(withKey, plain + 60 * kSubunitsPerUnit);
  EXPECT_LT(withKey, plain + 160 * kSubunitsPerUnit);
  EXPECT_EQ(fromStart(segments, 1u << 3), plain);
  EXPECT_EQ(fromStart("0 -200 0 -100 door 3\n50 -180 50 -160 key 3"), GoalDistance::kUnreachable)
      << "the key is behind its door";
}

constexpr int kMaxTicksStill = 2 * kTicksPerSecond;

// A closed room on face 0 with its goal at the right, and these segments in it.
std::shared_ptr<const Level> roomLevel(const std::string& segments) {
  return roomOf("-60 -185", "95 -180",
                "-120 -200 120 -200\n120 -200 120 -140\n120 -140 -120 -140\n-120 -140 -120 -200\n" + segments);
}

// Returns whether the player finishes within this number of ticks.
bool finishes(Demo& demo, Game& game, std::uint32_t slot, int ticks) {
  std::vector<Input> inputs(slot + 1);
  inputs[slot] = {Input::kPresent};
  for (int tick = 0; tick < ticks; ++tick) {
    game.advance(inputs);
    if (game.player(slot).finished()) return true;
    inputs[slot].buttons = demo.choose(game, slot).buttons | Input::kPresent;
  }
  return false;
}

// Demonstrations that play a level of the game from its start.
class Demonstration {
 public:
  // They join one after the other, so many ticks apart.
  Demonstration(std::shared_ptr<const Level> level, std::uint32_t players, std::uint32_t ticksApart)
      : game_(std::move(level)), demos_(players, Demo(shippedWay)), ticksApart_(ticksApart), places_(players) {}

  void play(std::uint32_t ticks) {
    while (game_.tick() < ticks && !game_.over()) {
      std::vector<Input> inputs(demos_.size());
      for (std::uint32_t slot = 0; slot < inputs.size(); ++slot) {
        if (game_.tick() < slot * ticksApart_) continue;
        inputs[slot].buttons = demos_[slot].choose(game_, slot).buttons | Input::kPresent;
        EXPECT_TRUE(isInput(inputs[slot]));
      }
      game_.advance(inputs);
      noteMotion();
    }
  }

  const Game& game() const { return game_; }
  // For which no player moved.
  int mostTicksStill() const { return mostTicksStill_; }

 private:
  void noteMotion() {
    std::vector<Point> places(demos_.size());
    for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) places[slot] = game_.world().entities()[slot].position;
    ticksStill_ = places == places_ ? ticksStill_ + 1 : 0;
    mostTicksStill_ = std::max(mostTicksStill_, ticksStill_);
    places_ = std::move(places);
  }

  Game game_;
  std::vector<Demo> demos_;
  std::uint32_t ticksApart_;
  std::vector<Point> places_;
  int ticksStill_ = 0;
  int mostTicksStill_ = 0;
};

std::shared_ptr<const Level> levelIn(const std::string& file) {
  std::shared_ptr<const Level> level = loadLevel(readText(file)).level;
  if (!level) throw std::logic_error(file + " is invalid");
  return level;
}

std::uint32_t ticksOfWay(const Level& level) {
  const std::optional<Solution> way = shippedWay(level);
  if (!way) throw std::logic_error(level.title + " has no recorded way; run tests/levels/record.sh");
  return static_cast<std::uint32_t>(way->size());
}

// The demonstration stood still for 15 s on "Four downs" and on "The order of corners".
TEST(Demo, StandsStillForAtMostTwoSecondsOnEveryLevel) {
  for (const std::string& file : shippedLevels()) {
    const auto level = levelIn(file);
    Demonstration all(level, level->players, 0);
    all.play(ticksOfWay(*level) + 1);  // one tick to join
    EXPECT_TRUE(all.game().over()) << file;
    EXPECT_LE(all.mostTicksStill(), kMaxTicksStill) << file;
  }
}

TEST(Demo, WhoJoinsLaterBeginsTogetherWithTheOthers) {
  for (const std::string& file : shippedLevels()) {
    const auto level = levelIn(file);
    if (level->players == 1) continue;
    Demonstration all(level, level->players, kTicksPerSecond);
    all.play(3 * (ticksOfWay(*level) + kTicksPerSecond));
    EXPECT_TRUE(all.game().over()) << file;
  }
}

TEST(Demo, AloneOnALevelForSeveralItPlaysItsPartAgainAndAgain) {
  for (const std::string& file : shippedLevels()) {
    const auto level = levelIn(file);
    if (level->players == 1) continue;
    Demonstration alone(level, 1, 0);
    alone.play(40 * kTicksPerSecond);
    EXPECT_LE(alone.mostTicksStill(), kMaxTicksStill) << file;
  }
}

// A missed input, here a second of other ones.
TEST(Demo, BeginsTheWayAgainAfterAMissedInput) {
  Game game(levelIn("levels/data/hexahedron/01_run_and_jump.level"));
  Demo demo(shippedWay);
  EXPECT_FALSE(finishes(demo, game, 0, 100));
  for (int tick = 0; tick < kTicksPerSecond; ++tick) game.advance(std::vector{Input{Input::kPresent | Input::kLeft}});
  EXPECT_TRUE(finishes(demo, game, 0, static_cast<int>(ticksOfWay(game.level())) + 2));
}

TEST(Demo, SearchesAWayOnALevelWithoutARecordedOne) {
  Demo demo;
  Game game(roomLevel("-10 -200 0 -190 hazard\n0 -190 10 -200 hazard\n"));
  EXPECT_TRUE(finishes(demo, game, 0, 3000));
}

// The key is on the other side of the start.
TEST(Demo, FinishesALevelWithADoor) {
  Demo demo;
  Game game(roomLevel("-100 -180 -100 -160 key 3\n50 -200 50 -140 door 3\n"));
  EXPECT_TRUE(finishes(demo, game, 0, 3000));
  EXPECT_EQ(game.openDoors(), 1u << 3);
}

TEST(Demo, FinishesAlthoughItIsPushedOffItsPath) {
  Demo demo;
  Game game(roomLevel(""));
  std::vector<Input> inputs = {Input{Input::kPresent}};
  game.advance(inputs);
  for (int tick = 0; tick < 6000 && !game.player(0).finished(); ++tick) {
    game.advance(inputs);
    inputs[0].buttons = demo.choose(game, 0).buttons | Input::kPresent;
    if (tick % 150 < 3 && tick < 1000) inputs[0] = {Input::kPresent | Input::kLeft};
  }
  EXPECT_TRUE(game.player(0).finished());
}

TEST(Demo, PlaysTheNextRound) {
  Demo demo(shippedWay);
  Game first(roomLevel(""));
  EXPECT_TRUE(finishes(demo, first, 2, 3000));
  Game second(levelIn("levels/data/hexahedron/01_run_and_jump.level"));
  EXPECT_TRUE(finishes(demo, second, 2, 3000));
}

TEST(Demo, PressesNothingWhileAbsent) {
  Demo demo(shippedWay);
  const Game game(levelIn("levels/data/hexahedron/01_run_and_jump.level"));
  EXPECT_EQ(demo.choose(game, 0), Input{});
}

}  // namespace
}  // namespace platon::demo_test
