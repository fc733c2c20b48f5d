#include "client/menu/pages/settings_pages.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace platon::settings_pages_test {
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

bool isSetting(const MenuItem& item) {
  return item.kind != MenuItem::Kind::kHeading && item.kind != MenuItem::Kind::kAction;
}

MenuPage settingsPage(Settings& settings) { return platon::settingsPage(settings, SubPages()); }

TEST(SettingsPage, EverySettingCanBeChangedAndStaysValid) {
  Settings settings;
  for (std::size_t i = 0; i < settingsPage(settings).items.size(); ++i) {
    if (!isSetting(settingsPage(settings).items[i])) continue;
    const std::string name = settingsPage(settings).items[i].name;
    const std::string before = settings.text();
    settingsPage(settings).items[i].step(1);
    if (settings.text() == before) settingsPage(settings).items[i].step(-1);  // it was at its end
    EXPECT_NE(settings.text(), before) << name;
    for (int step = 0; step < 60; ++step) settingsPage(settings).items[i].step(-1);
    EXPECT_TRUE(parseSettings(settings.text()).errors.empty()) << name;
    for (int step = 0; step < 61; ++step) settingsPage(settings).items[i].step(1);
    EXPECT_TRUE(parseSettings(settings.text()).errors.empty()) << name;
  }
}

TEST(SettingsPage, AKeyThatIsHeldDoesNotGoBackAndForthBetweenTwoValues) {
  Settings settings;
  int found = 0;
  for (std::size_t i = 0; i < settingsPage(settings).items.size(); ++i) {
    if (!isSetting(settingsPage(settings).items[i])) continue;
    std::vector<std::string> values;
    for (int step = 0; step < 3; ++step) {
      values.push_back(settingsPage(settings).items[i].value);
      settingsPage(settings).items[i].step(1);
    }
    const bool flips = values[0] != values[1] && values[0] == values[2];
    EXPECT_EQ(settingsPage(settings).items[i].repeats(), !flips) << settingsPage(settings).items[i].name;
    if (flips) ++found;
  }
  EXPECT_GE(found, 13);
}

TEST(SettingsPage, WithOthersTheGameSpeedCannotBeChosen) {
  Settings settings;
  EXPECT_EQ(platon::settingsPage(settings, SubPages(), false).items.size() + 1, settingsPage(settings).items.size());
}

TEST(SettingsPage, HintsAreOnWhileOneIsLeft) {
  Settings settings;
  settings.firstKeys = false;
  const auto item = [&settings] {
    for (MenuItem& found : settingsPage(settings).items) {
      if (found.name == "Hints for new players") return found;
    }
    return MenuItem();
  };
  EXPECT_EQ(item().value, "on") << "the elements are left";
  item().step(1);
  EXPECT_EQ(item().value, "off");
  EXPECT_EQ(settings.untold, UntoldElements{0});
  EXPECT_FALSE(settings.firstKeys || settings.firstDown || settings.firstLook);
  item().step(1);
  EXPECT_EQ(item().value, "on");
  EXPECT_TRUE(settings.firstKeys && settings.firstDown && settings.firstLook);
  EXPECT_EQ(settings.untold, UntoldElements());
}

TEST(SettingsPage, EachSettingIsInAGroup) {
  Settings settings;
  const MenuPage page = settingsPage(settings);
  EXPECT_FALSE(isSetting(page.items.front()));
  EXPECT_TRUE(page.standsAside);
}

class ControlsPageTest : public testing::Test {
 protected:
  MenuPage page() { return controlsPage(bindings_, form_); }
  MenuItem row(Control control) { return page().items[static_cast<std::size_t>(control)]; }
  void press(Key key, KeyEvent::Kind kind = KeyEvent::Kind::kPress) { page().takeKey({key, kind}); }
  bool waits() { return page().takeKey != nullptr; }
  std::string note() { return page().notes.front(); }

  Bindings bindings_;
  ControlsForm form_;
};

TEST_F(ControlsPageTest, ShowsTheKeysOfEachControl) {
  EXPECT_EQ(row(Control::kLeft).value, "← or A, stick ←");
  EXPECT_EQ(row(Control::kSay).value, "T, pad X");
  bindings_.clear(Control::kSay);
  EXPECT_EQ(row(Control::kSay).value, "none");
  EXPECT_EQ(page().items.size(), kControlCount + 1);
}

TEST_F(ControlsPageTest, AChosenRowWaitsForTheNextKey) {
  EXPECT_FALSE(waits());
  row(Control::kJump).choose();
  ASSERT_TRUE(waits());
  EXPECT_EQ(row(Control::kJump).value, "…");
  press(Key::kEnter, KeyEvent::Kind::kRepeat);  // of the key that has chosen the row
  press(Key::kEnter, KeyEvent::Kind::kRelease);
  press(Key::kPadCreep);  // a stick that is not at rest
  ASSERT_TRUE(waits());
  press(Key::kJ);
  EXPECT_FALSE(waits());
  EXPECT_EQ(bindings_.controlOf(Key::kJ), Control::kJump);
  EXPECT_EQ(note(), "“Jump” has J now.");
}

TEST_F(ControlsPageTest, TellsFromWhomAKeyWasTaken) {
  row(Control::kJump).choose();
  press(Key::kV);
  EXPECT_EQ(note(), "“Jump” has taken V from “Next level, or vote”, which has pad Y now.");
  row(Control::kJump).choose();
  press(Key::kT);
  EXPECT_EQ(note(), "“Jump” has taken T from “Talk to all players”, which has pad X now.");
}

TEST_F(ControlsPageTest, EscapeAndStartLeaveEverythingAsItWas) {
  for (const Key key : {Key::kEscape, Key::kPadStart}) {
    row(Control::kJump).choose();
    press(key);
    EXPECT_FALSE(waits());
    EXPECT_EQ(bindings_, Bindings());
  }
}

TEST_F(ControlsPageTest, DeleteTakesAllKeys) {
  row(Control::kJump).choose();
  press(Key::kDelete);
  EXPECT_EQ(bindings_.keysOf(Control::kJump), ControlKeys());
}

TEST_F(ControlsPageTest, AFunctionKeyThatDoesNothingElseIsTaken) {
  row(Control::kVote).choose();
  press(Key::kF5);
  EXPECT_FALSE(waits());
  EXPECT_EQ(note(), "“Next level, or vote” has F5 now.");
  EXPECT_EQ(bindings_.keysOf(Control::kVote).first, Key::kF5);
}

TEST_F(ControlsPageTest, KeysOfTheProgramAreRefused) {
  row(Control::kJump).choose();
  press(Key::kF11);
  EXPECT_TRUE(waits());
  EXPECT_EQ(note().substr(0, 22), "F11 cannot be chosen. ");
  EXPECT_EQ(bindings_, Bindings());
}

TEST_F(ControlsPageTest, ResetGivesTheDefaults) {
  for (const Key key : {Key::kJ, Key::kV, Key::kPadX}) {
    row(Control::kJump).choose();
    press(key);
  }
  EXPECT_NE(bindings_, Bindings());
  page().items.back().choose();
  EXPECT_EQ(bindings_, Bindings());
}

class SettingsPagesTest : public testing::Test {
 protected:
  SettingsPagesTest() {
    menu_.open([] { return MenuPage{.title = "Pause", .items = {{.name = "Settings"}}}; });
    pages_.show(MenuPage::Place::kLeft);
  }
  bool shows(const std::string& title) const { return menu_.layout(font_).title.text == title; }
  void tap(Key key) { menu_.handle({key}, font_); }
  void openControls() {
    const MenuPage page = settingsPage(settings_);
    const auto item = std::find_if(page.items.begin(), page.items.end(),
                                   [](const MenuItem& it) { return it.name == "Keys and buttons"; });
    menu_.setFocus(static_cast<std::size_t>(item - page.items.begin()));
    tap(Key::kEnter);
  }

  const Font font_;
  Settings settings_;
  Menu menu_;
  SettingsPages pages_{menu_, settings_};
};

TEST_F(SettingsPagesTest, LeadToTheKeysAndBack) {
  EXPECT_TRUE(shows("Settings"));
  openControls();
  EXPECT_TRUE(shows("Keys and buttons"));
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Settings"));
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Pause"));
}

TEST_F(SettingsPagesTest, TheNextKeyIsTheKeyOfTheRowAndMovesNothing) {
  openControls();
  tap(Key::kEnter);
  tap(Key::kArrowDown);
  EXPECT_EQ(settings_.bindings.controlOf(Key::kArrowDown), Control::kLeft);
  EXPECT_EQ(menu_.focus(), 0U);
  tap(Key::kArrowDown);
  EXPECT_EQ(menu_.focus(), 1U) << "menus keep their keys";
}

TEST_F(SettingsPagesTest, EscapeAndTheMouseCancelTheWaiting) {
  openControls();
  tap(Key::kEnter);
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Keys and buttons"));
  tap(Key::kEnter);
  menu_.handle(PointerEvent{.kind = PointerEvent::Kind::kPress}, font_);
  tap(Key::kArrowDown);
  EXPECT_EQ(menu_.focus(), 1U);
  EXPECT_EQ(settings_.bindings, Bindings());
}

}  // namespace
}  // namespace platon::settings_pages_test
