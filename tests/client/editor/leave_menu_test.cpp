#include "client/editor/leave_menu.h"

#include <gtest/gtest.h>

#include <optional>

namespace platon {
namespace {

using Choice = LeaveMenu::Choice;

std::optional<Choice> pressed(LeaveMenu& menu, Key key) { return menu.handle({key, KeyEvent::Kind::kPress}); }

TEST(LeaveMenuTest, WithUnsavedChangesItAsks) {
  LeaveMenu menu;
  menu.open(true);
  pressed(menu, Key::kArrowDown);
  EXPECT_EQ(pressed(menu, Key::kEnter), Choice::kSaveAndLeave);
  EXPECT_FALSE(menu.isOpen());
  menu.open(true);
  pressed(menu, Key::kArrowUp);
  EXPECT_EQ(pressed(menu, Key::kEnter), Choice::kLeave);
}

TEST(LeaveMenuTest, WithoutChangesThereIsNothingToSave) {
  LeaveMenu menu;
  menu.open(false);
  pressed(menu, Key::kArrowDown);
  EXPECT_EQ(pressed(menu, Key::kEnter), Choice::kLeave);
}

TEST(LeaveMenuTest, EscapeGoesBack) {
  LeaveMenu menu;
  menu.open(true);
  pressed(menu, Key::kArrowDown);
  EXPECT_EQ(pressed(menu, Key::kEscape), Choice::kBack);
  EXPECT_FALSE(menu.isOpen());
}

TEST(LeaveMenuTest, AClosedMenuShowsNothing) {
  const Font font;
  LeaveMenu menu;
  EXPECT_TRUE(menu.overlay(font, 1280).texts.empty());
  EXPECT_EQ(pressed(menu, Key::kEnter), std::nullopt);
  menu.open(true);
  EXPECT_EQ(menu.overlay(font, 1280).texts.size(), 4U);
}

}  // namespace
}  // namespace platon
