#include "platon/game/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tests/shared/game/standing_player.h"

namespace platon::player_test {
namespace {

constexpr std::int32_t kFloor = units(-200);
constexpr std::int32_t kRunSpeed = 3277;

TEST(PlayerTest, ShapeIsARegular16Gon) {
  const Convex shape = playerShape();
  ASSERT_EQ(shape.vertices().size(), 16u);
  for (const Point vertex : shape.vertices()) EXPECT_NEAR(std::hypot(vertex.x, vertex.y), kPlayerRadius, 1);
  EXPECT_EQ(shape.centre(), Point());
  EXPECT_EQ(shape.bounds().low, Point(-kApothem, -kApothem));
  EXPECT_EQ(shape.bounds().high, Point(kApothem, kApothem));
  EXPECT_EQ(*shape.turned(Angle::degrees(90)) == shape, false) << "the same polygon, but with a different first vertex";
}

TEST(PlayerTest, FallsAndComesToRest) {
  PlayedGame played(cubeLevel("0 0 0 0", {kFlatFloor}));
  played.run(1, kNone);
  EXPECT_EQ(played.position(), Point(0, -kGravity));
  played.run(1, kNone);
  EXPECT_EQ(played.position(), Point(0, -3 * kGravity));
  played.run(100, kNone);
  EXPECT_EQ(played.position(), Point(0, kFloor + kApothem));
  EXPECT_EQ(played.player().velocity, Point());
  EXPECT_EQ(played.player().ground, Point(0, PlayerState::kUnit));
  const Point rest = played.position();
  played.run(1000, kNone);
  EXPECT_EQ(played.position(), rest);
}

void expectToStandAndJumpOut(const std::string& start, const std::string& lines) {
  SCOPED_TRACE(lines);
  PlayedGame played(cubeLevel(start, {lines}));
  played.run(200, kNone);
  EXPECT_EQ(played.player().ground, Point(0, PlayerState::kUnit));
  const Point rest = played.position();
  played.run(100, kNone);
  EXPECT_EQ(played.position(), rest);
  played.run(10, Input::kJump);
  EXPECT_GT(played.position().y, rest.y + units(30));
}

TEST(PlayerTest, StandsBetweenTwoSteepSegmentsAndCanJumpOut) {
  expectToStandAndJumpOut("0 0 0 0", "-100 0 0 -173\n0 -173 100 0");
}

TEST(PlayerTest, StandsBetweenASteepSegmentAndAWallOrOverhang) {
  expectToStandAndJumpOut("0 -60 30 0", "-100 0 0 -173\n0 -173 0 50");
  expectToStandAndJumpOut("0 60 30 0", "100 0 0 -173\n0 -173 0 50");
  expectToStandAndJumpOut("0 -60 30 0", "-100 0 0 -173\n0 -173 -30 50");
  expectToStandAndJumpOut("0 60 30 0", "100 0 0 -173\n0 -173 30 50");
}

TEST(PlayerTest, FallsNoFasterThanTheLimit) {
  PlayedGame played(cubeLevel("0 0 0 0", {}));
  std::int32_t fastest = 0;
  for (int tick = 0; tick < 380; ++tick) {
    played.run(1, kNone);
    fastest = std::min(fastest, played.player().velocity.y);
  }
  EXPECT_EQ(fastest, -5632);
  EXPECT_GE(played.entity().crossings, 4u) << "the player falls around the cube";
  EXPECT_EQ(played.entity().angle, Angle());
}

TEST(PlayerTest, AcceleratesToTheRunSpeed) {
  for (const int way : {-1, 1}) {
    PlayedGame played = standingOn(kFlatFloor);
    const std::uint8_t button = way < 0 ? Input::kLeft : Input::kRight;
    for (int tick = 1; tick <= 30; ++tick) {
      const Point before = played.position();
      played.run(1, button);
      EXPECT_EQ(played.player().velocity, Point(way * std::min(410 * tick, kRunSpeed), 0)) << tick;
      EXPECT_EQ(played.position() - before, played.player().velocity);
      EXPECT_TRUE(played.grounded());
    }
  }
}

TEST(PlayerTest, LeftAndRightTogetherDoNothing) {
  PlayedGame played = standingOn(kFlatFloor);
  const Point before = played.position();
  played.run(20, Input::kLeft | Input::kRight);
  EXPECT_EQ(played.position(), before);
}

TEST(PlayerTest, StopsByFriction) {
  PlayedGame played = standingOn(kFlatFloor);
  played.run(20, Input::kRight);
  std::int32_t speed = kRunSpeed;
  while (speed > 0) {
    played.run(1, kNone);
    speed = std::max(speed - 546, 0);
    EXPECT_EQ(played.player().velocity, Point(speed, 0));
  }
  const Point rest = played.position();
  played.run(500, kNone);
  EXPECT_EQ(played.position(), rest);
}

TEST(PlayerTest, AWallStopsARun) {
  PlayedGame played = standingOn(kFlatFloor + "\n100 -200 100 0");
  played.run(120, Input::kRight);
  EXPECT_EQ(played.position(), Point(units(100) - kApothem, kFloor + kApothem));
  EXPECT_EQ(played.player().velocity.x, 0);
  EXPECT_TRUE(played.grounded());
}

TEST(PlayerTest, HasThreeSpeeds) {
  for (const auto& [button, speed] :
       {std::pair<std::uint8_t, std::int32_t>{0, kRunSpeed}, {Input::kWalk, 2185}, {Input::kCreep, 1092}}) {
    PlayedGame played = standingOn(kFlatFloor);
    played.run(20, Input::kRight | button);
    EXPECT_EQ(played.player().velocity.x, speed);
    played.run(20, Input::kLeft | button);
    EXPECT_EQ(played.player().velocity.x, -speed);
  }
}

// On the ground 4 ticks stop a run and 8 reach full speed the other way; without the faster turn-round it took 16.
TEST(PlayerTest, TurnsRoundFaster) {
  PlayedGame played = standingOn(kFlatFloor);
  played.run(30, Input::kRight);
  std::int32_t speed = kRunSpeed;
  int ticks = 0;
  for (; speed > -kRunSpeed; ++ticks) {
    speed = speed > 0 ? std::max(speed - 956, -410) : std::max(speed - 410, -kRunSpeed);
    played.run(1, Input::kLeft);
    ASSERT_EQ(played.player().velocity.x, speed) << ticks;
  }
  EXPECT_EQ(ticks, 11);
  played.run(3, Input::kLeft | Input::kJump);
  played.run(1, Input::kRight | Input::kJump);
  EXPECT_EQ(played.player().velocity.x, -kRunSpeed + 410) << "in the air";
}

TEST(PlayerTest, RestsOnASlope) {
  for (const char* slope :
       {"-240 -240 240 -200", "-240 -240 240 0", "-240 -240 240 240", "-240 100 240 -177", "-200 200 200 -220"}) {
    PlayedGame played = standingOn(slope, "0 0 80 0");
    played.run(100, kNone);
    ASSERT_TRUE(played.grounded()) << slope;
    const Point rest = played.position();
    for (int tick = 0; tick < 2000; ++tick) {
      played.run(1, kNone);
      ASSERT_EQ(played.position(), rest) << slope << ", tick " << tick;
      ASSERT_TRUE(played.grounded());
    }
  }
}

TEST(PlayerTest, SlidesDownASteepSegment) {
  PlayedGame played = standingOn("-100 -240 100 240", "0 -30 0 0");
  const Point before = played.position();
  played.run(30, kNone);
  EXPECT_FALSE(played.grounded());
  EXPECT_LT(played.position().y, before.y - units(20));
}

// A jump against a steep segment, pressed towards it, rises hardly higher than one beside it. The run speed and the
// acceleration in the air would carry it up by hundreds of units.
TEST(PlayerTest, NobodyClimbsASteepSegment) {
  for (const char* steep : {"40 -200 180 -30", "40 -200 120 0", "40 -200 60 100"}) {
    PlayedGame played = standingOn(kFlatFloor + "\n" + steep);
    const std::int32_t ground = played.position().y;
    std::int32_t peak = ground;
    for (int tick = 0; tick < 200; ++tick) {
      played.run(1, static_cast<std::uint8_t>(Input::kRight | (tick % 60 < 30 ? Input::kJump : 0)));
      peak = std::max(peak, played.position().y);
    }
    EXPECT_LE(peak - ground, 61350 + units(5)) << steep;
  }
}

TEST(PlayerTest, RunsUpAndDownSlopesAtTheRunSpeed) {
  for (const char* slope : {"-240 -240 240 -60", "-240 -240 240 240", "-240 200 240 -100"}) {
    for (const std::uint8_t way : {Input::kLeft, Input::kRight}) {
      PlayedGame played = standingOn(slope, "0 0 80 0");
      played.run(60, kNone);
      played.run(20, way);
      for (int tick = 0; tick < 15; ++tick) {
        const Point before = played.position();
        played.run(1, way);
        ASSERT_TRUE(played.grounded()) << slope << ", tick " << tick;
        const Point move = played.position() - before;
        ASSERT_NEAR(std::hypot(move.x, move.y), kRunSpeed, 33) << slope << ", tick " << tick;
      }
    }
  }
}

TEST(PlayerTest, StaysOnTheGroundOverAGentleCrestAndDip) {
  PlayedGame played =
      standingOn("-240 -160 -100 -160\n-100 -160 0 -153\n0 -153 100 -160\n100 -160 240 -150", "0 -200 -130 0");
  for (int tick = 0; tick < 160; ++tick) {
    played.run(1, Input::kRight);
    ASSERT_TRUE(played.grounded()) << tick << " at " << played.position().x;
    if (played.position().x > units(200)) return;
  }
  FAIL() << "the player did not get across";
}

// Runs once around the four side faces.
TEST(PlayerTest, RunsAroundTheCubeOnALevelFloor) {
  PlayedGame played(cubeLevel("0 0 -180 0", {kFlatFloor, kFlatFloor, kFlatFloor, kFlatFloor}));
  played.run(60, kNone);
  played.run(20, Input::kRight);
  const Point start = played.position();
  for (int tick = 0; tick < 800 && played.entity().crossings < 4; ++tick) {
    played.run(1, Input::kRight);
    ASSERT_TRUE(played.grounded()) << tick;
    ASSERT_EQ(played.player().velocity, Point(kRunSpeed, 0)) << tick;
    ASSERT_EQ(played.position().y, start.y) << tick;
  }
  EXPECT_EQ(played.entity().part, 0u);
  EXPECT_EQ(played.entity().crossings, 4u);
  EXPECT_EQ(played.entity().angle, Angle());
}

// Crosses the three edges of a corner: up, right, and down again. The angles at a corner of the cube add up to 270
// degrees, 90 less than on a plane.
TEST(PlayerTest, APathAroundACornerRotatesUpBy90Degrees) {
  const std::string first = "90 215 170 215\n0 40 0 230";
  const std::string top = "180 -215 240 -215";
  PlayedGame played(cubeLevel("0 130 230 0", {first, "", "", "", top}));
  played.run(30, kNone);
  ASSERT_TRUE(played.grounded());
  played.run(24, Input::kRight | Input::kJump);
  EXPECT_EQ(played.entity().part, 4u);
  std::vector<std::uint32_t> parts;
  for (int tick = 0; tick < 300; ++tick) {
    played.run(1, played.entity().part == 4 ? Input::kRight : kNone);
    if (parts.empty() || parts.back() != played.entity().part) parts.push_back(played.entity().part);
  }
  EXPECT_EQ(parts, (std::vector<std::uint32_t>{4, 1, 0}));
  EXPECT_EQ(played.entity().angle, Angle::degrees(270));
  EXPECT_TRUE(played.grounded());
  EXPECT_EQ(played.position().x, kApothem) << "the player stands on the segment that was a wall";
  EXPECT_EQ(played.player().ground, Point(0, PlayerState::kUnit)) << "in the player's own frame";
}

TEST(PlayerTest, MovesTheSameInItsOwnFrameForEveryStartAngle) {
  for (const int degrees : {0, 90, 180, 270}) {
    const std::string box = "-200 -200 200 -200\n200 -200 200 200\n200 200 -200 200\n-200 200 -200 -200";
    PlayedGame played(cubeLevel("0 0 0 " + std::to_string(degrees), {box}));
    played.run(120, kNone);
    EXPECT_TRUE(played.grounded());
    EXPECT_EQ(played.position(), rotate(Point(0, kFloor + kApothem), Angle::degrees(degrees))) << degrees;
    played.run(10, Input::kRight);
    const Point run = rotate(played.position(), -Angle::degrees(degrees));
    EXPECT_EQ(run.y, kFloor + kApothem);
    EXPECT_GT(run.x, 0);
    EXPECT_EQ(played.player().velocity, Point(kRunSpeed, 0));
  }
}

TEST(PlayerTest, AMirroredLevelGivesAMirroredPath) {
  const std::string lines = "-240 -200 100 -200\n100 -200 160 -150\n20 -120 80 -120";
  const std::string mirrored = "240 -200 -100 -200\n-100 -200 -160 -150\n-20 -120 -80 -120";
  PlayedGame one(cubeLevel("0 0 -180 0", {lines}));
  PlayedGame two(cubeLevel("0 0 -180 0", {mirrored}));
  const std::uint8_t script[] = {Input::kRight, Input::kRight | Input::kJump, Input::kLeft, Input::kJump, kNone};
  for (int tick = 0; tick < 250; ++tick) {
    const std::uint8_t buttons = script[tick / 12 % 5];
    const auto swapped = static_cast<std::uint8_t>((buttons & Input::kJump) | ((buttons & Input::kLeft) << 1) |
                                                   ((buttons & Input::kRight) >> 1));
    one.run(1, buttons);
    two.run(1, swapped);
    ASSERT_NEAR(one.position().x, -two.position().x, 40) << tick;
    ASSERT_NEAR(one.position().y, two.position().y, 40) << tick;
  }
}

// Long slopes just too steep to stand on give the greatest speeds: falls and slides feed each other.
TEST(PlayerTest, StaysFarBelowTheLargestSpeedOfAState) {
  double fastest = 0;
  for (const int degrees : {50, 51, 55, 65, 80}) {
    const double slope = std::tan(degrees * 3.14159265 / 180);
    std::string lines;
    const auto heightAt = [slope](int x) { return static_cast<int>(3500 - slope * (x + 3900)); };
    for (int x = -3900; heightAt(x + 500) > -4000; x += 600) {  // with gaps between them, down to the right
      lines += std::to_string(x) + " " + std::to_string(heightAt(x)) + " " + std::to_string(x + 500) + " " +
               std::to_string(heightAt(x + 500)) + "\n";
    }
    const std::string text = "HEXAHEDRON\n0 -3880 3600 0\n5 0 0\n8000\n%\n" + lines + "%\n%\n%\n%\n%\n";
    PlayedGame played(levelOf(text));
    for (int tick = 0; tick < 1500; ++tick) {
      played.run(1, static_cast<std::uint8_t>(tick / 9 % 4 == 0 ? Input::kRight | Input::kJump : Input::kRight));
      const Point velocity = played.player().velocity;
      fastest = std::max(fastest, std::hypot(velocity.x, velocity.y));
    }
  }
  EXPECT_GT(fastest, 6500) << "a free fall has 5632";
  EXPECT_LT(fastest, kMaxPlayerSpeed * 2.0 / 3);
}

}  // namespace
}  // namespace platon::player_test
