#include "client/quality/quality_trial.h"

#include <gtest/gtest.h>

namespace platon::quality_trial_test {
namespace {

// The time of a picture on a machine without graphics hardware: mostly that of its samples.
double timeOf(const Quality& quality) { return 0.006 * quality.samples + (quality.particles ? 0.001 : 0); }

// Draws a picture that is finished after this time.
void draw(QualityTrial& trial, QualityChoice& choice, double seconds) {
  Moment now{};
  bool drawn = false;
  const auto finish = [&] {
    if (drawn) now += Moment(static_cast<Moment::rep>(seconds * 1e6));
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
}  // namespace platon::quality_trial_test
