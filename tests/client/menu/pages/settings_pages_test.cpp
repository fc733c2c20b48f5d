#include "client/menu/pages/settings_pages.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "client/menu/pages/settings_page.h"

namespace platon::settings_pages_test {
namespace {

class SettingsPagesTest : public testing::Test {
 protected:
  SettingsPagesTest() {
    menu_.open([] { return MenuPage{.title = "Pause", .items = {{.name = "Settings"}}}; });
    pages_.show(MenuPage::Place::kLeft);
  }
  bool shows(const std::string& title) const { return menu_.layout(font_).title.text == title; }
  void tap(Key key) { menu_.handle({key}, font_); }
  void openControls() {
    const MenuPage page = settingsPage();
    const auto item = std::find_if(page.items.begin(), page.items.end(),
                                   [](const MenuItem& it) { return it.name == "Keys and buttons"; });
    menu_.setFocus(static_cast<std::size_t>(item - page.items.begin()));
    tap(Key::kEnter);
  }
  MenuPage settingsPage() {
    return platon::settingsPage(settings_, [] {});
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
