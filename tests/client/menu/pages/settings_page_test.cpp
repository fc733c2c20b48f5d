#include "client/menu/pages/settings_page.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::settings_page_test {
namespace {

bool isSetting(const MenuItem& item) {
  return item.kind != MenuItem::Kind::kHeading && item.kind != MenuItem::Kind::kAction;
}

MenuPage settingsPage(Settings& settings) {
  return platon::settingsPage(settings, [] {});
}

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
  EXPECT_EQ(platon::settingsPage(
                settings, [] {}, false)
                    .items.size() +
                1,
            settingsPage(settings).items.size());
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
  item().step(1);
  EXPECT_EQ(item().value, "on");
  EXPECT_TRUE(settings.firstKeys);
  EXPECT_EQ(settings.untold, UntoldElements());
}

TEST(SettingsPage, EachSettingIsInAGroup) {
  Settings settings;
  const MenuPage page = settingsPage(settings);
  EXPECT_FALSE(isSetting(page.items.front()));
  EXPECT_TRUE(page.standsAside);
}

}  // namespace
}  // namespace platon::settings_page_test
