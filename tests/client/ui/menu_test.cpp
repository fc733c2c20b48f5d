#include "client/ui/menu.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace platon {
namespace {

const Font& font() {
  static const Font font;
  return font;
}

bool shows(const Menu& menu, const Settings& settings, const std::string& content) {
  const Overlay overlay = menu.overlay(settings, font(), 1280);
  return std::any_of(overlay.texts.begin(), overlay.texts.end(),
                     [&](const Overlay::Text& text) { return text.content.find(content) != std::string::npos; });
}

void down(Menu& menu, Settings& settings, int steps) {
  for (int i = 0; i < steps; ++i) menu.step(Menu::Step::kDown, settings);
}

TEST(Menu, AClosedMenuShowsAndDoesNothing) {
  Menu menu;
  Settings settings;
  down(menu, settings, 1);
  menu.step(Menu::Step::kMore, settings);
  menu.choose(settings);
  EXPECT_EQ(settings.text(), Settings().text());
  EXPECT_FALSE(menu.leaving());
  EXPECT_TRUE(menu.overlay(settings, font(), 1280).texts.empty());
}

TEST(Menu, ResumeClosesTheMenu) {
  Menu menu;
  Settings settings;
  menu.toggle();
  EXPECT_TRUE(shows(menu, settings, "Resume"));
  menu.choose(settings);
  EXPECT_FALSE(menu.open());
  EXPECT_FALSE(menu.leaving());
}

TEST(Menu, TheLastItemLeavesAndPrecedesTheFirst) {
  Menu menu;
  Settings settings;
  menu.toggle();
  menu.step(Menu::Step::kUp, settings);
  menu.choose(settings);
  EXPECT_TRUE(menu.leaving());
}

TEST(Menu, EverySettingCanBeChangedAndStaysValid) {
  Menu menu;
  Settings settings;
  menu.toggle();
  for (int item = 1; item <= 7; ++item) {
    down(menu, settings, 1);
    const std::string before = settings.text();
    menu.step(Menu::Step::kMore, settings);
    EXPECT_NE(settings.text(), before) << "item " << item;
    for (int i = 0; i < 20; ++i) menu.step(Menu::Step::kLess, settings);
    EXPECT_TRUE(parseSettings(settings.text()).errors.empty());
    for (int i = 0; i < 21; ++i) menu.step(Menu::Step::kMore, settings);
    EXPECT_TRUE(parseSettings(settings.text()).errors.empty());
  }
  EXPECT_TRUE(menu.open());
}

TEST(Menu, TheWholeMenuIsOnTheScreen) {
  Menu menu;
  const Settings settings;
  menu.toggle();
  const Overlay overlay = menu.overlay(settings, font(), 960);
  // A title, nine items and the values of seven settings.
  ASSERT_EQ(overlay.texts.size(), 1U + 9U + 9U);
  const auto filled = [](const Overlay::Text& text) { return !text.content.empty(); };
  EXPECT_EQ(std::count_if(overlay.texts.begin(), overlay.texts.end(), filled), 1 + 9 + 7);
  for (const Overlay::Text& text : overlay.texts) {
    EXPECT_TRUE(text.place.x > 0 && text.place.x + font().width(text.content) * text.size < 960) << text.content;
    EXPECT_TRUE(text.place.y > 0 && text.place.y < Overlay::kHeight) << text.content;
  }
  ASSERT_EQ(overlay.panels.size(), 3U) << "the dimmed screen, the menu and the selected item";
  for (const Overlay::Panel& panel : overlay.panels) {
    EXPECT_TRUE(panel.low.x >= 0 && panel.high.x <= 960 && panel.low.x < panel.high.x);
    EXPECT_TRUE(panel.low.y >= 0 && panel.high.y <= Overlay::kHeight && panel.low.y < panel.high.y);
  }
}

TEST(Menu, ItemsAndValuesDoNotOverlap) {
  Menu menu;
  Settings settings;
  settings.comfort.turnSpeed = 2;
  menu.toggle();
  menu.step(Menu::Step::kDown, settings);
  const Overlay overlay = menu.overlay(settings, font(), 960);
  int rows = 0;
  for (const Overlay::Text& name : overlay.texts) {
    for (const Overlay::Text& value : overlay.texts) {
      if (value.place.y != name.place.y || value.place.x <= name.place.x || value.content.empty()) continue;
      EXPECT_LT(name.place.x + font().width(name.content) * name.size, value.place.x) << name.content;
      ++rows;
    }
  }
  EXPECT_EQ(rows, 7);
}

}  // namespace
}  // namespace platon
