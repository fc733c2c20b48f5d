#include "client/menu/pages/quality_items.h"

#include <gtest/gtest.h>

namespace platon::quality_items_test {
namespace {

TEST(QualityItems, TheLevelsAreInOrder) {
  QualityChoice choice{QualityLevel::kLow, {}, {}};
  for (const QualityLevel level :
       {QualityLevel::kMedium, QualityLevel::kHigh, QualityLevel::kAll, QualityLevel::kAll}) {
    qualityItem(choice).step(1);
    EXPECT_EQ(choice.level, level);
  }
  EXPECT_EQ(qualityItem(choice).value, "everything on");
  for (int i = 0; i < 9; ++i) qualityItem(choice).step(-1);
  EXPECT_EQ(qualityItem(choice).value, "low");
}

TEST(QualityItems, TheScaleGoesFromAHalfToOne) {
  QualityChoice choice{QualityLevel::kHigh, {}, {}};
  renderScaleItem(choice).step(-1);
  EXPECT_EQ(choice.scale, 0.95);
  EXPECT_EQ(renderScaleItem(choice).value, "95 %");
  EXPECT_EQ(qualityItem(choice).value, "high, changed");
  for (int i = 0; i < 30; ++i) renderScaleItem(choice).step(-1);
  EXPECT_EQ(choice.scale, 0.5);
  EXPECT_EQ(renderScaleItem(choice).part, 0);
  renderScaleItem(choice).set(0.52);
  EXPECT_EQ(choice.scale, 0.75);
  renderScaleItem(choice).set(1);
  EXPECT_EQ(choice.scale, 1);
}

TEST(QualityItems, SamplesAre1Or2Or4) {
  QualityChoice choice{QualityLevel::kHigh, {}, {}};
  for (const int samples : {2, 4, 4}) {
    multisamplingItem(choice).step(1);
    EXPECT_EQ(choice.samples, samples);
  }
  EXPECT_EQ(multisamplingItem(choice).value, "4 samples");
  for (int i = 0; i < 3; ++i) multisamplingItem(choice).step(-1);
  EXPECT_EQ(choice.samples, 1);
  EXPECT_EQ(multisamplingItem(choice).value, "off");
}

TEST(QualityItems, ALevelReplacesWhatWasChanged) {
  QualityChoice choice{QualityLevel::kHigh, 0.5, 4};
  qualityItem(choice).step(-1);
  EXPECT_EQ(choice, (QualityChoice{QualityLevel::kMedium, {}, {}}));
}

TEST(QualityItems, MeasuringForgetsTheLevel) {
  QualityChoice choice{QualityLevel::kLow, 0.5, 4};
  measureItem(choice).choose();
  EXPECT_EQ(choice, QualityChoice());
  EXPECT_EQ(qualityItem(choice).value, "automatic");
}

}  // namespace
}  // namespace platon::quality_items_test
