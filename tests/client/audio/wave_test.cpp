#include "client/audio/wave.h"

#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "tests/client/audio/pcm_laws.h"

namespace platon::wave_test {
namespace {

Pcm loopOf(const Wave& wave, double peak) { return finishLoop(std::span(&wave, 1), peak); }

TEST(Wave, AToneHasItsFrequency) {
  for (const double frequency : {110.0, 440.0, 1000.0}) {
    Wave wave(1, Wave::Shape::kOnce);
    wave.add(Tone{.frequency = frequency, .decay = 100, .seconds = 1});
    EXPECT_NEAR(brightnessOf(finishOnce(wave, 1)), frequency, 0.01 * frequency);
  }
}

TEST(Wave, AGlideEndsAtItsFrequency) {
  Wave wave(2, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = 200, .endFrequency = 800, .decay = 100, .seconds = 2});
  int rises = 0;  // through 0 in the last quarter, in which the frequency rises from 566 to 800
  const auto samples = wave.samples();
  for (std::size_t i = samples.size() * 3 / 4; i + 1 < samples.size(); ++i)
    rises += samples[i] < 0 && samples[i + 1] >= 0;
  EXPECT_NEAR(rises, 0.5 * (800 - 565.7) / std::log(std::sqrt(2)), 2);
}

TEST(Wave, ASoundThatEndsStartsAndEndsAtZeroWithoutOffset) {
  Wave wave(0.5, Wave::Shape::kOnce);
  wave.add(Puff{.cutoff = 90, .level = 1, .attack = 0.0001, .decay = 10, .seconds = 2});
  const Pcm pcm = finishOnce(wave, 1);
  EXPECT_EQ(pcm.frames(), 24000u);
  EXPECT_EQ(pcm.samples.front(), 0);
  EXPECT_EQ(pcm.samples.back(), 0);
  EXPECT_LT(std::abs(offsetOf(pcm, 0)), 0.05);
}

TEST(Wave, ThePeakIsThatAskedFor) {
  Wave wave(0.5, Wave::Shape::kOnce);
  wave.add(Tone{});
  EXPECT_NEAR(peakOf(finishOnce(wave, 1)), kMaxSample, 1);
  EXPECT_NEAR(peakOf(finishOnce(wave, 0.25)), kMaxSample / 4, 1);
  Wave loop(0.5, Wave::Shape::kLoop);
  loop.addBreath(300, 1, 1);
  EXPECT_LE(peakOf(loopOf(loop, 0.5)), kMaxSample / 2 + 1);
}

TEST(Wave, WhatReachesBeyondTheEndOfALoopContinuesAtItsBeginning) {
  const Tone tone{.start = 0.25, .frequency = 440, .decay = 0.2, .seconds = 0.9};
  Wave early(1, Wave::Shape::kLoop);
  early.add(tone);
  Wave late(1, Wave::Shape::kLoop);
  Tone shifted = tone;
  shifted.start = 0.75;
  late.add(shifted);
  const std::size_t half = early.samples().size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    ASSERT_EQ(early.samples()[i], late.samples()[i + half]) << i;
    ASSERT_EQ(early.samples()[i + half], late.samples()[i]) << i;
  }
}

TEST(Wave, LoopsHaveNoSeam) {
  Wave swell(1, Wave::Shape::kLoop);
  swell.addSwell(0.6, 0.9, 333.3, 1);
  EXPECT_FALSE(hasSeam(loopOf(swell, 1)));
  Wave breath(1, Wave::Shape::kLoop);
  breath.addBreath(100, 1, 3);
  breath.tremble(3, 0.5, 1);
  EXPECT_FALSE(hasSeam(loopOf(breath, 1)));
}

// The law of the test above refuses what has a seam.
TEST(Wave, ABrokenSineHasASeam) {
  Pcm pcm;
  for (int i = 0; i < 1000; ++i) pcm.samples.push_back(static_cast<std::int16_t>(10000 * std::cos(i * 0.0157)));
  EXPECT_TRUE(hasSeam(pcm));
}

TEST(Wave, EchoesAreLaterAndSofter) {
  Wave wave(1, Wave::Shape::kOnce);
  wave.add(Tone{.frequency = 500, .decay = 0.02, .seconds = 0.1});
  const std::vector<double> dry(wave.samples().begin(), wave.samples().end());
  wave.echo(0.25, 0.5, 2);
  for (std::size_t i = 0; i < 4800; ++i) {
    ASSERT_EQ(wave.samples()[i], dry[i]);
    ASSERT_DOUBLE_EQ(wave.samples()[i + 12000], dry[i] / 2);
    ASSERT_DOUBLE_EQ(wave.samples()[i + 24000], dry[i] / 4);
    ASSERT_EQ(wave.samples()[i + 36000], 0);
  }
}

}  // namespace
}  // namespace platon::wave_test
