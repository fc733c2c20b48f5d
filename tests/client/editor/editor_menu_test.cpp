#include "client/editor/editor_menu.h"

#include <gtest/gtest.h>

#include "tests/client/editor/test_editor.h"

namespace platon::editor_menu_test {
namespace {

TEST(EditorMenuTest, CtrlSAsksToSave) {
  TestEditor editor;
  EXPECT_FALSE(editor.takeSave());
  editor.key(Key::kS, true);
  EXPECT_TRUE(editor.takeSave());
  EXPECT_FALSE(editor.takeSave());
}

TEST(EditorMenuTest, EscapeEndsOneThingAfterAnother) {
  TestEditor editor("-50 10 50 10\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kEscape);
  EXPECT_FALSE(editor.menu().isOpen());
  editor.key(Key::kEscape);
  EXPECT_TRUE(editor.menu().isOpen());
  editor.key(Key::kEscape);
  EXPECT_FALSE(editor.menu().isOpen());
  EXPECT_FALSE(editor.leaving());
}

TEST(EditorMenuTest, SaveAndLeaveWaitsForTheSave) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.drag({0, {-50, 10}}, {0, {50, 10}});
  editor.askToLeave();
  editor.key(Key::kArrowDown);
  editor.key(Key::kEnter);
  EXPECT_TRUE(editor.takeSave());
  EXPECT_FALSE(editor.leaving());
  editor.failSave("no space");
  EXPECT_FALSE(editor.leaving());
  editor.key(Key::kS, true);
  editor.markSaved();
  EXPECT_FALSE(editor.leaving()) << "only saved";
  editor.askToLeave();
  editor.key(Key::kArrowDown);
  editor.key(Key::kEnter);
  EXPECT_TRUE(editor.leaving());
}

}  // namespace
}  // namespace platon::editor_menu_test
