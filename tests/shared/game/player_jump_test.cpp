// Jumps and falls of a player: the curve of each, and what ends them.
#include "platon/game/player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/shared/game/standing_player.h"

namespace platon::player_jump_test {
namespace {

constexpr std::int32_t kApexSpeed = 1600;
constexpr std::int32_t kJumpSpeed = 6024;
constexpr std::int32_t kCutJumpSpeed = 1800;
constexpr std::int32_t kJumpHeight = 61350;

// The rise of a jump whose button is held, from this speed on.
std::int32_t riseFrom(std::int32_t speed) {
  std::int32_t rise = 0;
  while (true) {
    speed -= speed <= kApexSpeed ? kGravity / 2 : kGravity;
    if (speed <= 0) return rise;
    rise += speed;
  }
}

// The jump height: 61350 subunits, 59.91 units. The speed falls by the gravity in each tick, the first one included,
// and by half of it at the apex.
TEST(PlayerJumpTest, JumpHeightIs61350Subunits) {
  PlayedGame played = standingOn(kFlatFloor);
  const std::int32_t ground = played.position().y;
  EXPECT_EQ(riseFrom(kJumpSpeed), kJumpHeight);
  std::int32_t peak = 0;
  int airborne = 0;
  do {
    played.run(1, Input::kJump);
    peak = std::max(peak, played.position().y - ground);
    ++airborne;
  } while (!played.grounded() && airborne < 1000);
  EXPECT_EQ(peak, kJumpHeight);
  EXPECT_EQ(airborne, 50);
  EXPECT_EQ(played.position().y, ground);
}

// A player that rolls over a segment's end with an upward speed jumped 116 units high.
TEST(PlayerJumpTest, AJumpSetsTheUpwardSpeedWhateverItWas) {
  PlayedGame played = standingOn("-240 -200 -60 -200\n-60 -200 0 -130", "0 -200 -180 0");
  std::int32_t upwards = 0;
  for (int tick = 0; tick < 200 && (played.grounded() || played.player().velocity.y <= 0); ++tick) {
    played.run(1, Input::kRight);
    upwards = played.player().velocity.y;
  }
  ASSERT_GT(upwards, 1000) << "the player leaves the slope upwards";
  const std::int32_t from = played.position().y;
  played.run(1, Input::kRight | Input::kJump);
  EXPECT_EQ(played.player().velocity.y, kJumpSpeed - kGravity);
  std::int32_t peak = from;
  for (int tick = 0; tick < 30; ++tick) {
    played.run(1, Input::kRight | Input::kJump);
    peak = std::max(peak, played.position().y);
  }
  EXPECT_LE(peak - from, kJumpHeight);
}

TEST(PlayerJumpTest, GravityIsHalfAtTheApexWhileTheButtonIsHeld) {
  for (const bool held : {false, true}) {
    PlayedGame played = standingOn(kFlatFloor);
    played.run(20, Input::kJump);
    const std::int32_t speed = played.player().velocity.y;
    ASSERT_LE(speed, kApexSpeed);
    ASSERT_GT(speed, 0);
    played.run(1, held ? Input::kJump : kNone);
    EXPECT_EQ(played.player().velocity.y, speed - (held ? kGravity / 2 : kGravity));
  }
}

TEST(PlayerJumpTest, FallsFasterWhileTheDownButtonIsHeld) {
  PlayedGame played(cubeLevel("0 0 0 0", {}));
  for (int tick = 1; tick <= 40; ++tick) {
    played.run(1, Input::kDown);
    EXPECT_EQ(played.player().velocity.y, std::max(-kGravity * tick, -7680)) << tick;
  }
  for (int tick = 1; tick <= 20; ++tick) {
    played.run(1, kNone);
    EXPECT_EQ(played.player().velocity.y, std::min(-7680 + kGravity * tick, -5632)) << tick << " after release";
  }
}

// The peak of a jump below a ceiling from x = `end` to the right.
std::int32_t peakBesideCeiling(std::int32_t end) {
  PlayedGame played = standingOn(kFlatFloor + "\n" + std::to_string(end) + " -150 200 -150", "0 0 -180 0");
  std::int32_t peak = played.position().y;
  const std::int32_t ground = peak;
  for (int tick = 0; tick < 40; ++tick) {
    played.run(1, Input::kJump);
    peak = std::max(peak, played.position().y);
  }
  return peak - ground;
}

// The ball reaches 11.8 units to the right: a ceiling that begins at 8 clips 4 units of it.
TEST(PlayerJumpTest, TheEndOfACeilingThatClips4UnitsDoesNotEndAJump) {
  EXPECT_EQ(peakBesideCeiling(12), kJumpHeight);
  for (const std::int32_t end : {11, 10, 9, 8}) EXPECT_GT(peakBesideCeiling(end), units(54)) << end;
  for (const std::int32_t end : {5, 4, 2}) EXPECT_LT(peakBesideCeiling(end), units(40)) << "the ball is below it";
}

TEST(PlayerJumpTest, APlayerThatPassesAnEndLosesItsSpeedTowardsIt) {
  PlayedGame played = standingOn(kFlatFloor + "\n31 -150 200 -150", "0 0 -180 0");
  played.run(3, Input::kRight);
  int stopped = 0;
  for (int tick = 0; tick < 12; ++tick) {
    const std::int32_t x = played.position().x;
    const std::int32_t speed = played.player().velocity.x + (tick == 0 ? 410 : 205);
    played.run(1, Input::kRight | Input::kJump);
    ASSERT_GT(played.player().velocity.y, kApexSpeed) << "the jump goes on";
    if (played.position().x - x == speed) continue;
    ++stopped;
    EXPECT_EQ(played.player().velocity.x, 0) << tick;
  }
  EXPECT_GT(stopped, 0);
}

TEST(PlayerJumpTest, ASlantedCeilingIsNoEnd) {
  PlayedGame played = standingOn(kFlatFloor + "\n-60 -90 45 -195", "0 0 -180 0");
  std::int32_t slowest = kJumpSpeed;
  for (int tick = 0; tick < 12; ++tick) {
    played.run(1, Input::kJump);
    slowest = std::min(slowest, played.player().velocity.y);
  }
  EXPECT_LT(slowest, kApexSpeed);
}

TEST(PlayerJumpTest, AHeldButtonJumpsOnce) {
  PlayedGame played = standingOn(kFlatFloor);
  const std::int32_t ground = played.position().y;
  played.run(50, Input::kJump);
  EXPECT_TRUE(played.grounded());
  for (int tick = 0; tick < 100; ++tick) {
    played.run(1, Input::kJump);
    ASSERT_EQ(played.position().y, ground) << tick;
  }
  played.run(1, kNone);
  played.run(1, Input::kJump);
  EXPECT_GT(played.position().y, ground) << "pressed again";
}

std::int32_t peakOfJumpHeldFor(int ticks) {
  PlayedGame played = standingOn(kFlatFloor);
  const std::int32_t ground = played.position().y;
  std::int32_t peak = 0;
  for (int tick = 0; tick < 60; ++tick) {
    played.run(1, tick < ticks ? Input::kJump : kNone);
    peak = std::max(peak, played.position().y - ground);
  }
  return peak;
}

TEST(PlayerJumpTest, JumpHeightGrowsWithTheTimeTheButtonIsHeld) {
  // Released after one tick: one tick at full speed, then 5 ticks from a speed of 1800.
  std::int32_t least = kJumpSpeed - kGravity;
  for (int tick = 1; kCutJumpSpeed - kGravity * tick > 0; ++tick) least += kCutJumpSpeed - kGravity * tick;
  EXPECT_EQ(peakOfJumpHeldFor(1), least);
  std::int32_t last = 0;
  for (int ticks = 1; ticks <= 15; ++ticks) {
    const std::int32_t peak = peakOfJumpHeldFor(ticks);
    EXPECT_GT(peak, last) << ticks;
    last = peak;
  }
  EXPECT_EQ(peakOfJumpHeldFor(25), kJumpHeight);
  EXPECT_EQ(peakOfJumpHeldFor(40), kJumpHeight);
}

TEST(PlayerJumpTest, ACeilingEndsAJump) {
  PlayedGame played = standingOn(kFlatFloor + "\n-100 -150 100 -150");
  std::int32_t peak = played.position().y;
  int airborne = 0;
  do {
    played.run(1, Input::kJump);
    peak = std::max(peak, played.position().y);
  } while (!played.grounded() && ++airborne < 100);
  EXPECT_EQ(peak, units(-150) - kApothem);
  EXPECT_LT(airborne, 30);
}

// Runs off the ledge at x = 0 and presses the button in the tick `late` after the last one on the ground, 2 or more.
bool jumpsAfterLedge(int late) {
  PlayedGame played = standingOn("-240 0 0 0", "0 -60 20 0");
  played.run(60, kNone);
  int ticks = 0;
  do {
    played.run(1, Input::kRight);
  } while (played.grounded() && ++ticks < 200);
  EXPECT_FALSE(played.grounded());
  played.run(late - 2, Input::kRight);
  played.run(1, Input::kRight | Input::kJump);
  return played.player().velocity.y > 0;
}

TEST(PlayerJumpTest, CanJumpInThe6TicksAfterTheLastOneOnTheGround) {
  for (int late = 2; late <= 6; ++late) EXPECT_TRUE(jumpsAfterLedge(late)) << late;
  for (int late = 7; late <= 14; ++late) EXPECT_FALSE(jumpsAfterLedge(late)) << late;
}

TEST(PlayerJumpTest, DoesNotJumpAgainInTheAir) {
  PlayedGame played = standingOn(kFlatFloor);
  played.run(2, Input::kJump);
  played.run(1, kNone);
  const std::int32_t speed = played.player().velocity.y;
  played.run(1, Input::kJump);
  EXPECT_EQ(played.player().velocity.y, speed - kGravity);
}

// Presses the button `early` ticks before the tick in which a falling player lands.
bool jumpsWhenPressedEarly(int early) {
  PlayedGame falling(cubeLevel("0 0 -100 0", {kFlatFloor}));
  falling.run(1, kNone);
  int lands = 1;
  for (PlayedGame watched = falling; !watched.grounded(); ++lands) watched.run(1, kNone);
  PlayedGame played = falling;
  played.run(lands - 1 - early, kNone);
  for (int tick = 0; tick < early + 3; ++tick) {
    played.run(1, Input::kJump);
    if (played.player().velocity.y > 0) return true;
  }
  return false;
}

TEST(PlayerJumpTest, AJumpPressedUpTo5TicksEarlyStartsOnLanding) {
  for (int early = 0; early <= 5; ++early) EXPECT_TRUE(jumpsWhenPressedEarly(early)) << early;
  for (int early = 6; early <= 12; ++early) EXPECT_FALSE(jumpsWhenPressedEarly(early)) << early;
}

}  // namespace
}  // namespace platon::player_jump_test
