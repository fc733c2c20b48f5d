#include "client/audio/music_fade.h"

#include <gtest/gtest.h>

namespace platon::music_fade_test {
namespace {

constexpr SolidKind kA = SolidKind::kHexahedron;
constexpr SolidKind kB = SolidKind::kIcosahedron;
constexpr double kStep = 0.01;

void advance(MusicFade& fade, std::optional<SolidKind> solid, double seconds) {
  for (double time = 0; time < seconds - kStep / 2; time += kStep) fade.advance(solid, kStep);
}

TEST(MusicFade, TheFirstPadFadesIn) {
  MusicFade fade;
  EXPECT_EQ(fade.gain(kA), 0);
  advance(fade, kA, MusicFade::kFadeSeconds / 2);
  EXPECT_NEAR(fade.gain(kA) * fade.gain(kA), 0.5, 1e-9);
  advance(fade, kA, MusicFade::kFadeSeconds);
  EXPECT_EQ(fade.gain(kA), 1);
}

TEST(MusicFade, AChangeOfSolidKeepsTheLoudness) {
  MusicFade fade;
  advance(fade, kA, 10);
  for (double time = 0; time < MusicFade::kFadeSeconds - kStep; time += kStep) {
    fade.advance(kB, kStep);
    ASSERT_NEAR(fade.gain(kA) * fade.gain(kA) + fade.gain(kB) * fade.gain(kB), 1, 1e-9);
  }
  fade.advance(kB, 1);
  EXPECT_EQ(fade.gain(kA), 0);
  EXPECT_EQ(fade.gain(kB), 1);
}

TEST(MusicFade, TheGoalMakesItSofterForAWhile) {
  MusicFade fade;
  advance(fade, kA, 10);
  fade.duck();
  advance(fade, kA, MusicFade::kAttackSeconds);
  EXPECT_NEAR(fade.gain(kA), MusicFade::kDuckGain, 1e-9);
  advance(fade, kA, MusicFade::kDuckSeconds - MusicFade::kAttackSeconds);
  EXPECT_NEAR(fade.gain(kA), MusicFade::kDuckGain, 0.02);
  advance(fade, kA, MusicFade::kReleaseSeconds + 2 * kStep);
  EXPECT_EQ(fade.gain(kA), 1);
}

TEST(MusicFade, NoStepOfTheGainIsAudible) {
  MusicFade fade;
  double before = 0;
  for (int i = 0; i < 3000; ++i) {
    if (i == 700) fade.duck();
    fade.advance(i < 1500 ? std::optional(kA) : std::nullopt, kStep);
    ASSERT_NEAR(fade.gain(kA), before, 0.03) << i;
    before = fade.gain(kA);
  }
}

}  // namespace
}  // namespace platon::music_fade_test
