#include "levels/reach/flight_envelope.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shared/game/played_game.h"

namespace platon::flight_envelope_test {
namespace {

TEST(FlightEnvelopeTest, HasTheHeightOfAJump) {
  EXPECT_DOUBLE_EQ(FlightEnvelope::measured().jumpHeight(), 61350.0 / 1024);
}

TEST(FlightEnvelopeTest, TimesGrowWithTheDistance) {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  EXPECT_EQ(envelope.fallTicks(0), 1);
  EXPECT_GE(envelope.riseTicks(envelope.jumpHeight()), 25);
  for (int height = 1; height < 60; ++height) EXPECT_GE(envelope.riseTicks(height), envelope.riseTicks(height - 1));
  for (int depth = 1; depth < 2000; ++depth) EXPECT_GE(envelope.fallTicks(depth), envelope.fallTicks(depth - 1));
}

// However the button is pressed, nobody falls more slowly.
TEST(FlightEnvelopeTest, NoFallIsSlower) {
  for (const int released : {0, 1, 5, 20, 30, 60, 100}) {
    PlayedGame played(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}));
    played.run(60, kNone);
    std::int32_t top = 0;
    int ticks = 0;
    for (int tick = 0; tick < 100; ++tick) {
      const std::int32_t before = played.position().y;
      played.run(1, tick < std::max(released, 1) ? Input::kJump : kNone);
      if (played.grounded()) break;
      ticks = played.position().y > before ? 0 : ticks + 1;
      if (ticks == 0) top = played.position().y;
      const double depth = (top - played.position().y) / 1024.0;
      EXPECT_LE(ticks, FlightEnvelope::measured().fallTicks(depth) + 1) << released << " " << tick;
    }
  }
}

// Up a ramp of 45 degrees, over its end, and a jump at the last moment or before.
TEST(FlightEnvelopeTest, ARunUpASlopeGivesAHigherJumpButNoneThatIsHigher) {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  double most = 0;
  for (int late = 0; late <= envelope.lateTicks(); ++late) {
    PlayedGame played(levelOf("HEXAHEDRON\n0 -400 20 0\n5 0 0\n2000\n%\n-600 0 0 0\n0 0 200 200\n%\n%\n%\n%\n%\n"));
    played.run(60, kNone);
    while (played.grounded()) played.run(1, Input::kRight);
    const std::int32_t ground = played.position().y;
    played.run(late, Input::kRight);
    std::int32_t top = ground;
    for (int tick = 0; tick < 40; ++tick) {
      played.run(1, Input::kRight | Input::kJump);
      top = std::max(top, played.position().y);
    }
    most = std::max(most, (top - ground) / 1024.0 - envelope.jumpHeight());
  }
  EXPECT_GT(most, 1);
  const double push = envelope.pushGain(envelope.runSpeed());
  EXPECT_LE(most, envelope.slopeGain(envelope.runSpeed()) + push);
  EXPECT_GT(most, push) << "or it would be enough";
}

TEST(FlightEnvelopeTest, ASlideIsAsFastAsItsSlopeLets) {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  const double run = envelope.runSpeed();
  EXPECT_DOUBLE_EQ(envelope.slidingSpeed(1.19, run), envelope.slideSpeed());
  EXPECT_DOUBLE_EQ(envelope.slidingSpeed(4, run), run);
  EXPECT_DOUBLE_EQ(envelope.slidingSpeed(4, 5), 5) << "faster before";
  double most = 0;
  for (const std::uint8_t buttons : {kNone, Input::kRight, Input::kLeft}) {
    PlayedGame played(levelOf("HEXAHEDRON\n0 -400 700 0\n5 0 0\n2000\n%\n-420 673 -20 -20\n%\n%\n%\n%\n%\n"));
    for (int ticks = 0; ticks < 150; ++ticks) {
      played.run(1, static_cast<std::uint8_t>(buttons | Input::kDown));
      most = std::max(most, played.player().velocity.x / 1024.0);
    }
  }
  EXPECT_LE(most, envelope.slidingSpeed(693.0 / 400, run));
  EXPECT_GT(most, envelope.slidingSpeed(693.0 / 400, run) - 0.1);
}

// A tick on the ground takes a pace from who has slid, whatever is pressed.
TEST(FlightEnvelopeTest, ATickOnTheGroundTakesAPaceAtLeast) {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  EXPECT_DOUBLE_EQ(envelope.speedOf(0), envelope.runSpeed());
  EXPECT_DOUBLE_EQ(envelope.speedOf(FlightEnvelope::kPaces - 1), envelope.slideSpeed());
  for (const std::uint8_t buttons : {kNone, Input::kRight, Input::kLeft}) {
    PlayedGame played(
        levelOf("HEXAHEDRON\n0 -400 500 0\n5 0 0\n2000\n%\n-420 480 -20 0\n-20 0 900 0\n%\n%\n%\n%\n%\n"));
    const auto pace = [&] { return envelope.paceOf(played.player().velocity.x / 1024.0); };
    played.run(1, kNone);
    while (!played.grounded()) played.run(1, kNone);
    ASSERT_GE(pace(), 4) << "a slide";
    for (int ticks = 0; ticks < 10; ++ticks) {
      const int before = pace();
      played.run(1, buttons);
      EXPECT_LE(pace(), std::max(before - 1, 0)) << ticks;
    }
  }
}

TEST(FlightEnvelopeTest, AFallFromAGreatHeightTakesAsLongAsInTheGame) {
  PlayedGame played(levelOf("HEXAHEDRON\n0 0 4000 0\n5 0 0\n10000\n%\n%\n%\n%\n%\n%\n"));
  played.run(1, kNone);
  int ticks = 1;
  while (played.position().y > units(0)) {
    played.run(1, kNone);
    ++ticks;
  }
  EXPECT_GE(FlightEnvelope::measured().fallTicks(4000), ticks);
  EXPECT_LE(FlightEnvelope::measured().fallTicks(4000), ticks * 1.1);
}

}  // namespace
}  // namespace platon::flight_envelope_test
