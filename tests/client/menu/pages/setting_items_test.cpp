#include "client/menu/pages/setting_items.h"

#include <array>

#include <gtest/gtest.h>

namespace platon::setting_items_test {
namespace {

constexpr std::array<NamedValue, 3> kSpeeds{{{1, "slow"}, {5, "normal"}, {20, "fast"}}};
constexpr SliderRange kRange{0.5, 2, 0.05};

TEST(SettingItems, AToggleTurnsItsFlagOver) {
  bool flag = false;
  EXPECT_EQ(toggleItem("flag", flag).value, "off");
  for (const int direction : {1, -1}) {
    const bool before = flag;
    toggleItem("flag", flag).step(direction);
    EXPECT_NE(flag, before);
  }
  flag = true;
  EXPECT_EQ(toggleItem("flag", flag).value, "on");
  EXPECT_EQ(toggleItem("flag", flag).part, 1);
}

TEST(SettingItems, AChoiceStepsFromTheNearestValueAndEndsAtTheLast) {
  double speed = 6;
  EXPECT_EQ(choiceItem("speed", speed, kSpeeds).value, "normal");
  choiceItem("speed", speed, kSpeeds).step(1);
  EXPECT_EQ(speed, 20);
  choiceItem("speed", speed, kSpeeds).step(1);
  EXPECT_EQ(speed, 20);
  for (int i = 0; i < 5; ++i) choiceItem("speed", speed, kSpeeds).step(-1);
  EXPECT_EQ(speed, 1);
}

TEST(SettingItems, ASliderStaysInItsRangeAndOnItsSteps) {
  double zoom = 1;
  EXPECT_EQ(percentItem("zoom", zoom, kRange).value, "100 %");
  percentItem("zoom", zoom, kRange).step(1);
  EXPECT_EQ(zoom, 1.05);
  for (int i = 0; i < 50; ++i) percentItem("zoom", zoom, kRange).step(1);
  EXPECT_EQ(zoom, 2);
  percentItem("zoom", zoom, kRange).set(0);
  EXPECT_EQ(zoom, 0.5);
  percentItem("zoom", zoom, kRange).set(0.51);
  EXPECT_EQ(zoom, 1.25);
  EXPECT_DOUBLE_EQ(percentItem("zoom", zoom, kRange).part, 0.5);
}

}  // namespace
}  // namespace platon::setting_items_test
