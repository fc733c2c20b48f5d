#include "client/audio/sounds.h"

#include <gtest/gtest.h>

#include "tests/client/audio/pcm_laws.h"

namespace platon::sounds_test {
namespace {

class EverySound : public testing::TestWithParam<Sound> {};

INSTANTIATE_TEST_SUITE_P(Sounds, EverySound, testing::ValuesIn(kAllSounds));

TEST_P(EverySound, IsAlwaysTheSame) { EXPECT_EQ(makeSound(GetParam()).samples, makeSound(GetParam()).samples); }

TEST_P(EverySound, IsMonoAndNeitherSilentNorTooLoud) {
  const Pcm pcm = makeSound(GetParam());
  EXPECT_EQ(pcm.channels, 1);
  EXPECT_GT(peakOf(pcm), kMaxSample / 5);
  EXPECT_LE(peakOf(pcm), kMaxSample);
}

TEST_P(EverySound, HasNoOffset) { EXPECT_LT(std::abs(offsetOf(makeSound(GetParam()), 0)), 0.05); }

TEST_P(EverySound, NeitherClicksNorHasASeam) {
  const Pcm pcm = makeSound(GetParam());
  if (GetParam() == Sound::kRoll) {
    EXPECT_FALSE(hasSeam(pcm));
  } else {
    EXPECT_EQ(pcm.samples.front(), 0);
    EXPECT_EQ(pcm.samples.back(), 0);
  }
}

TEST_P(EverySound, IsNotShrill) { EXPECT_LT(brightnessOf(makeSound(GetParam())), 1000); }

TEST_P(EverySound, LastsAtMostFourSeconds) { EXPECT_LE(makeSound(GetParam()).frames(), 4u * kSampleRate); }

TEST(Sounds, FiveStepsOfTheScaleAreAnOctave) {
  for (int step = -10; step <= 10; ++step) EXPECT_NEAR(pentatonic(step + 5), 2 * pentatonic(step), 1e-9) << step;
  EXPECT_NEAR(pentatonic(3), 440, 0.01);
  for (int step = -10; step < 10; ++step) EXPECT_LT(pentatonic(step), pentatonic(step + 1)) << step;
}

}  // namespace
}  // namespace platon::sounds_test
