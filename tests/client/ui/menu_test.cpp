#include "client/ui/menu.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace platon {
namespace {

const Font& font() {
  static const Font font;
  return font;
}

bool says(const Menu& menu, const Settings& settings, const std::string& words) {
  const Overlay overlay = menu.overlay(settings, font(), 1280);
  return std::any_of(overlay.texts.begin(), overlay.texts.end(),
                     [&](const Overlay::Text& text) { return text.words.find(words) != std::string::npos; });
}

void down(Menu& menu, Settings& settings, int steps) {
  for (int i = 0; i < steps; ++i) menu.take(Menu::Step::kDown, settings);
}

TEST(Menu, ClosedItShowsAndDoesNothing) {
  Menu menu;
  Settings settings;
  down(menu, settings, 1);
  menu.take(Menu::Step::kMore, settings);
  menu.choose(settings);
  EXPECT_EQ(settings.text(), Settings().text());
  EXPECT_FALSE(menu.leaving());
  EXPECT_TRUE(menu.overlay(settings, font(), 1280).texts.empty());
}

TEST(Menu, ResumeClosesIt) {
  Menu menu;
  Settings settings;
  menu.toggle();
  EXPECT_TRUE(says(menu, settings, "Resume"));
  menu.choose(settings);
  EXPECT_FALSE(menu.open());
  EXPECT_FALSE(menu.leaving());
}

TEST(Menu, TheLastItemLeavesAndIsOneUpFromTheFirst) {
  Menu menu;
  Settings settings;
  menu.toggle();
  menu.take(Menu::Step::kUp, settings);
  menu.choose(settings);
  EXPECT_TRUE(menu.leaving());
}

TEST(Menu, EverySettingCanBeReachedAndStaysValid) {
  Menu menu;
  Settings settings;
  menu.toggle();
  for (int item = 1; item <= 7; ++item) {
    down(menu, settings, 1);
    const std::string before = settings.text();
    menu.take(Menu::Step::kMore, settings);
    EXPECT_NE(settings.text(), before) << "item " << item;
    for (int i = 0; i < 20; ++i) menu.take(Menu::Step::kLess, settings);
    EXPECT_EQ(parseSettings(settings.text()).error, "");
    for (int i = 0; i < 21; ++i) menu.take(Menu::Step::kMore, settings);
    EXPECT_EQ(parseSettings(settings.text()).error, "");
  }
  EXPECT_TRUE(menu.open());
}

TEST(Menu, AllOfItIsOnTheScreen) {
  Menu menu;
  const Settings settings;
  menu.toggle();
  for (const Overlay::Text& text : menu.overlay(settings, font(), 960).texts) {
    EXPECT_TRUE(text.place.x > 0 && text.place.x + font().width(text.words) * text.size < 960) << text.words;
    EXPECT_TRUE(text.place.y > 0 && text.place.y < Overlay::kHeight) << text.words;
  }
}

}  // namespace
}  // namespace platon
