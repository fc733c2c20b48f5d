#include "client/quality/quality_meter.h"

#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

namespace platon::quality_meter_test {
namespace {

using Times = std::array<double, kQualities.size()>;  // of a picture, by level

struct Outcome {
  QualityLevel chosen;
  int pictures;
  double spent;
};

// Measures a machine on which each picture takes the time of its level, and the first one of a level `first` more.
Outcome measure(const Times& times, double first = 0) {
  QualityMeter meter;
  Outcome outcome{meter.chosen(), 0, 0};
  for (std::optional<QualityLevel> last; const auto level = meter.next(); last = level) {
    const double seconds = times[static_cast<std::size_t>(*level)] + (level == last ? 0 : first);
    meter.add(seconds);
    outcome.spent += seconds;
    ++outcome.pictures;
  }
  outcome.chosen = meter.chosen();
  return outcome;
}

TEST(QualityMeter, ChoosesTheBestLevelThatHolds60PicturesASecond) {
  EXPECT_EQ(measure({0.001, 0.002, 0.003, 0.004}).chosen, QualityLevel::kAll);
  EXPECT_EQ(measure({0.008, 0.010, 0.012, 0.030}).chosen, QualityLevel::kHigh);
  EXPECT_EQ(measure({0.008, 0.010, 0.015, 0.030}).chosen, QualityLevel::kMedium);
  EXPECT_EQ(measure({0.011, 0.013, 0.015, 0.030}).chosen, QualityLevel::kLow);
}

TEST(QualityMeter, WithoutALevelThatHoldsItChoosesTheFastest) {
  EXPECT_EQ(measure({0.020, 0.030, 0.040, 0.050}).chosen, QualityLevel::kLow);
  EXPECT_EQ(measure({0.020, 0.018, 0.019, 0.050}).chosen, QualityLevel::kMedium);
}

TEST(QualityMeter, AMachineThatIsTooSlowToTryThemAllGetsTheLowest) {
  for (const double seconds : {0.045, 0.06, 0.11, 0.3, 5.0})
    EXPECT_EQ(measure({seconds, seconds, seconds, seconds}).chosen, QualityLevel::kLow) << seconds;
}

TEST(QualityMeter, TheLimitIsInclusive) {
  const double limit = QualityMeter::kHoldSeconds;
  EXPECT_EQ(measure({limit, limit, limit * 1.001, 0}).chosen, QualityLevel::kMedium);
}

TEST(QualityMeter, TheFirstPictureOfALevelIsNotCounted) {
  const Times times{0.002, 0.003, 0.004, 0.005};
  EXPECT_EQ(measure(times, 0.05).chosen, measure(times).chosen);
}

TEST(QualityMeter, OneSlowPictureChangesNothing) {
  QualityMeter meter;
  for (int picture = 0; meter.next(); ++picture) meter.add(picture % 4 == 1 ? 0.03 : 0.001);
  EXPECT_EQ(meter.chosen(), QualityLevel::kAll);
}

TEST(QualityMeter, EndsSoon) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> time(0, 0.3);
  for (int round = 0; round < 1000; ++round) {
    Times times;
    for (double& seconds : times) seconds = time(random);
    const Outcome outcome = measure(times);
    EXPECT_LE(outcome.pictures, static_cast<int>(QualityMeter::kPictures * kQualities.size()));
    EXPECT_LT(outcome.spent, QualityMeter::kMaxSeconds + 0.3) << "one picture more than the limit, at most";
  }
}

TEST(QualityMeter, AFasterMachineNeverGetsALowerQuality) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> time(0.001, 0.03);
  std::uniform_real_distribution<double> part(0.2, 1);
  for (int round = 0; round < 1000; ++round) {
    Times slow;
    Times fast;
    const double share = part(random);
    for (std::size_t i = 0; i < slow.size(); ++i) {
      slow[i] = time(random);
      fast[i] = slow[i] * share;
    }
    std::stable_sort(slow.begin(), slow.end());
    std::stable_sort(fast.begin(), fast.end());
    EXPECT_GE(measure(fast).chosen, measure(slow).chosen);
    EXPECT_GE(bestLevel(fast), bestLevel(slow));
  }
}

TEST(QualityMeter, ChoosesAsTheBenchmarkDoes) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> time(0.001, 0.016);
  for (int round = 0; round < 1000; ++round) {
    Times times;
    for (double& seconds : times) seconds = time(random);
    std::stable_sort(times.begin(), times.end());
    EXPECT_EQ(measure(times).chosen, bestLevel(times));
  }
}

TEST(QualityMeter, AfterTheChoiceNothingIsMeasured) {
  QualityMeter meter;
  while (meter.next()) meter.add(0.05);
  const QualityLevel chosen = meter.chosen();
  meter.add(0.001);
  EXPECT_EQ(meter.next(), std::nullopt);
  EXPECT_EQ(meter.chosen(), chosen);
}

// The time of a picture on a machine without graphics hardware: mostly that of its samples.
double timeOf(const Quality& quality) { return 0.006 * quality.samples + (quality.particles ? 0.001 : 0); }

// Draws a picture that is finished after this time.
void draw(QualityTrial& trial, QualityChoice& choice, double seconds) {
  Time now{};
  bool drawn = false;
  const auto finish = [&] {
    if (drawn) now += Time(static_cast<Time::rep>(seconds * 1e6));
  };
  trial.draw(
      choice, [&] { return now; }, finish, [&] { drawn = true; });
  EXPECT_TRUE(drawn);
}

// Shows pictures of a match until a level is set. Returns their number.
int show(QualityTrial& trial, QualityChoice& choice) {
  int pictures = 0;
  for (; !choice.level && pictures < 1000; ++pictures) draw(trial, choice, timeOf(trial.quality(choice)));
  return pictures;
}

TEST(QualityTrial, ChoosesALevelByTheFirstPictures) {
  QualityTrial trial;
  QualityChoice choice;
  const int pictures = show(trial, choice);
  EXPECT_EQ(choice.level, QualityLevel::kHigh);
  EXPECT_GT(pictures, QualityTrial::kSkipped);
  EXPECT_LE(pictures, QualityTrial::kSkipped + static_cast<int>(QualityMeter::kPictures * kQualities.size()));
}

TEST(QualityTrial, SlowPicturesInWhichTheLevelIsLoadedDoNotCount) {
  QualityTrial trial;
  QualityChoice choice;
  for (int i = 0; i < QualityTrial::kSkipped; ++i) draw(trial, choice, 3);
  show(trial, choice);
  EXPECT_EQ(choice.level, QualityLevel::kHigh);
}

TEST(QualityTrial, WhatThePlayerHasChosenStays) {
  QualityTrial trial;
  QualityChoice choice{QualityLevel::kLow, 0.6, 2};
  const QualityChoice before = choice;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(trial.quality(choice), before.quality());
    draw(trial, choice, 1);
  }
  EXPECT_EQ(choice, before);
}

TEST(QualityTrial, MeasuresAnewWhenThePlayerWantsIt) {
  QualityTrial trial;
  QualityChoice choice;
  show(trial, choice);
  choice = {};
  show(trial, choice);
  EXPECT_EQ(choice.level, QualityLevel::kHigh);
}

}  // namespace
}  // namespace platon::quality_meter_test
