#include "client/menu/pages/setting_items.h"

#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>

namespace platon::setting_items_test {
namespace {

std::vector<MenuItem> itemsOf(std::string_view name, Settings& settings) {
  const std::span<const Setting> table = settingTable();
  const auto found = std::find_if(table.begin(), table.end(), [name](const Setting& it) { return it.name == name; });
  return platon::itemsOf(*found, settings);
}
MenuItem itemOf(std::string_view name, Settings& settings) { return itemsOf(name, settings).front(); }

void step(std::string_view name, Settings& settings, int direction, int times = 1) {
  for (int i = 0; i < times; ++i) itemOf(name, settings).step(direction);
}

TEST(SettingItems, AToggleTurnsItsFlagOver) {
  Settings settings;
  EXPECT_EQ(itemOf("fullscreen", settings).value, "off");
  for (const int direction : {1, -1}) {
    const bool before = settings.fullscreen;
    step("fullscreen", settings, direction);
    EXPECT_NE(settings.fullscreen, before);
  }
  settings.fullscreen = true;
  EXPECT_EQ(itemOf("fullscreen", settings).value, "on");
  EXPECT_EQ(itemOf("fullscreen", settings).part, 1);
}

TEST(SettingItems, AChoiceStepsFromTheNearestValueAndEndsAtTheLast) {
  Settings settings;
  settings.comfort.turnRate = 6;
  EXPECT_EQ(itemOf("turn-speed", settings).value, "normal");
  step("turn-speed", settings, 1);
  EXPECT_EQ(settings.comfort.turnRate, 12);
  step("turn-speed", settings, 1, 2);
  EXPECT_EQ(settings.comfort.turnRate, 30);
  step("turn-speed", settings, -1, 6);
  EXPECT_EQ(settings.comfort.turnRate, 2);
}

TEST(SettingItems, ASliderStaysInItsRangeAndOnItsSteps) {
  Settings settings;
  EXPECT_EQ(itemOf("zoom", settings).value, "100 %");
  step("zoom", settings, 1);
  EXPECT_EQ(settings.zoom, 1.05);
  step("zoom", settings, 1, 50);
  EXPECT_EQ(settings.zoom, 2);
  itemOf("zoom", settings).set(0);
  EXPECT_EQ(settings.zoom, 0.5);
  itemOf("zoom", settings).set(0.51);
  EXPECT_EQ(settings.zoom, 1.25);
  EXPECT_DOUBLE_EQ(itemOf("zoom", settings).part, 0.5);
}

TEST(SettingItems, WordsGoRound) {
  Settings settings;
  EXPECT_EQ(itemOf("camera", settings).value, "follows you");
  step("camera", settings, -1);
  EXPECT_EQ(settings.comfort.view, CameraView::kFaceFade);
  step("camera", settings, 1);
  EXPECT_EQ(settings.comfort.view, CameraView::kFollow);
  EXPECT_EQ(itemOf("ball-colour", settings).value, "by your number");
  step("ball-colour", settings, -1);
  EXPECT_EQ(itemOf("ball-colour", settings).value, "cream");
  step("ball-colour", settings, 1);
  EXPECT_FALSE(settings.ball.colour);
}

TEST(SettingItems, TheLevelsOfQualityAreInOrder) {
  Settings settings;
  settings.quality = {QualityLevel::kLow, {}, {}};
  for (const QualityLevel level :
       {QualityLevel::kMedium, QualityLevel::kHigh, QualityLevel::kAll, QualityLevel::kAll}) {
    step("quality", settings, 1);
    EXPECT_EQ(settings.quality.level, level);
  }
  EXPECT_EQ(itemOf("quality", settings).value, "highest");
  step("quality", settings, -1, 9);
  EXPECT_EQ(itemOf("quality", settings).value, "low");
}

TEST(SettingItems, TheRenderScaleGoesFromAHalfToOne) {
  Settings settings;
  settings.quality = {QualityLevel::kHigh, {}, {}};
  step("render-scale", settings, -1);
  EXPECT_EQ(settings.quality.scale, 0.95);
  EXPECT_EQ(itemOf("render-scale", settings).value, "95 %");
  EXPECT_EQ(itemOf("quality", settings).value, "high, changed");
  step("render-scale", settings, -1, 30);
  EXPECT_EQ(settings.quality.scale, 0.5);
  EXPECT_EQ(itemOf("render-scale", settings).part, 0);
  itemOf("render-scale", settings).set(0.52);
  EXPECT_EQ(settings.quality.scale, 0.75);
  itemOf("render-scale", settings).set(1);
  EXPECT_EQ(settings.quality.scale, 1);
}

TEST(SettingItems, SamplesAre1Or2Or4) {
  Settings settings;
  settings.quality = {QualityLevel::kHigh, {}, {}};
  for (const int samples : {2, 4, 4}) {
    step("multisampling", settings, 1);
    EXPECT_EQ(settings.quality.samples, samples);
  }
  EXPECT_EQ(itemOf("multisampling", settings).value, "4 samples");
  step("multisampling", settings, -1, 3);
  EXPECT_EQ(settings.quality.samples, 1);
  EXPECT_EQ(itemOf("multisampling", settings).value, "off");
}

TEST(SettingItems, ALevelReplacesWhatWasChanged) {
  Settings settings;
  settings.quality = {QualityLevel::kHigh, 0.5, 4};
  step("quality", settings, -1);
  EXPECT_EQ(settings.quality, (QualityChoice{QualityLevel::kMedium, {}, {}}));
}

TEST(SettingItems, MeasuringForgetsTheLevel) {
  Settings settings;
  settings.quality = {QualityLevel::kLow, 0.5, 4};
  itemsOf("multisampling", settings).back().choose();
  EXPECT_EQ(settings.quality, QualityChoice());
  EXPECT_EQ(itemOf("quality", settings).value, "automatic");
}

TEST(SettingItems, EachSettingOfTheMenuHasAnItemWithItsLabel) {
  Settings settings;
  for (const Setting& setting : settingTable()) {
    if (setting.group == SettingGroup::kHidden) continue;
    const std::vector<MenuItem> items = platon::itemsOf(setting, settings);
    ASSERT_FALSE(items.empty()) << setting.name;
    EXPECT_EQ(items.front().name, setting.label);
    EXPECT_EQ(items.front().inMotion, setting.inMotion);
  }
}

}  // namespace
}  // namespace platon::setting_items_test
