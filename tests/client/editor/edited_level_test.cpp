#include "client/editor/edited_level.h"

#include <gtest/gtest.h>

#include "tests/client/editor/test_editor.h"

namespace platon {
namespace {

void addSegment(EditedLevel& level) {
  level.edit([](LevelDocument& document) { document.add({0, {0, 10}, {50, 10}, {}}); });
}

TEST(EditedLevelTest, ANewLevelIsUnsaved) {
  EXPECT_TRUE(EditedLevel(TestEditor::levelText(), false).unsaved());
  EXPECT_FALSE(EditedLevel(TestEditor::levelText(), true).unsaved());
}

TEST(EditedLevelTest, UndoLeadsBackToTheSavedText) {
  EditedLevel level(TestEditor::levelText(), true);
  addSegment(level);
  EXPECT_TRUE(level.unsaved());
  level.markSaved();
  EXPECT_TRUE(level.undo());
  EXPECT_TRUE(level.unsaved());
  EXPECT_TRUE(level.redo());
  EXPECT_FALSE(level.unsaved());
  EXPECT_FALSE(level.redo());
}

TEST(EditedLevelTest, AnEditThatChangesNothingIsNoStep) {
  EditedLevel level(TestEditor::levelText(), true);
  level.edit([](LevelDocument&) {});
  EXPECT_FALSE(level.undo());
}

TEST(EditedLevelTest, ReloadingCanBeUndone) {
  EditedLevel level(TestEditor::levelText(), true);
  level.reload(TestEditor::levelText("1 2 3 4\n"));
  EXPECT_FALSE(level.unsaved());
  EXPECT_TRUE(level.undo());
  EXPECT_EQ(level.text(), TestEditor::levelText());
}

TEST(EditedLevelTest, SegmentsThatTheShownLevelLacksAreFaulty) {
  EditedLevel level(TestEditor::levelText(), true);
  level.edit([](LevelDocument& document) { document.add({0, {-120, -188}, {-80, -188}, {}}); });
  EXPECT_FALSE(level.document().valid());
  ASSERT_EQ(level.faulty().size(), 1U);
  EXPECT_EQ(level.faulty().front().a, glm::dvec2(-120, -188));
  level.undo();
  EXPECT_TRUE(level.faulty().empty());
}

}  // namespace
}  // namespace platon
