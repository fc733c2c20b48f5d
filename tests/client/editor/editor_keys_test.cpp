#include <gtest/gtest.h>

#include <string>

#include <glm/geometric.hpp>

#include "tests/client/editor/test_editor.h"

namespace platon::editor_keys_test {
namespace {

TEST(EditorKeysTest, UndoAndRedo) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.drag({0, {-50, 10}}, {0, {50, 10}});
  const std::string drawn = editor.level().text();
  editor.key(Key::kZ, true);
  EXPECT_EQ(editor.level().text(), TestEditor::levelText());
  EXPECT_FALSE(editor.level().unsaved());
  editor.key(Key::kY, true);
  EXPECT_EQ(editor.level().text(), drawn);
  editor.key(Key::kZ, true);
  editor.key(Key::kZ, true, true);
  EXPECT_EQ(editor.level().text(), drawn);
  editor.key(Key::kY, true);
  EXPECT_EQ(editor.status().message, "nothing to redo");
}

TEST(EditorKeysTest, EveryToolHasAKey) {
  TestEditor editor;
  for (const EditToolFacts& facts : kEditTools) {
    editor.key(facts.key);
    EXPECT_EQ(editor.status().tool, facts.tool);
  }
}

TEST(EditorKeysTest, CtrlSAsksToSave) {
  TestEditor editor;
  EXPECT_FALSE(editor.takeSave());
  editor.key(Key::kS, true);
  EXPECT_TRUE(editor.takeSave());
  EXPECT_FALSE(editor.takeSave());
}

TEST(EditorKeysTest, DigitsSetTheNumberOfTheSelectedSegment) {
  TestEditor editor("-50 10 50 10 door 3\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit1);
  EXPECT_EQ(editor.all()[1].word.number, 1) << "a number of its own";
  editor.key(Key::kDigit2);
  EXPECT_EQ(editor.all()[1].word.number, 12);
  editor.key(Key::kDigit7);
  EXPECT_EQ(editor.all()[1].word.number, 7);
  editor.key(Key::kDigit8);
  EXPECT_EQ(editor.all()[1].word.number, 8) << "there is no door 78";
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit2);
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit1);
  EXPECT_EQ(editor.all()[1].word.number, 1) << "not 21: a click ends the number";
}

TEST(EditorKeysTest, AnUpHasTheNumberOfAnEdge) {
  TestEditor editor("-50 10 50 10 up 0\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit2);
  EXPECT_EQ(editor.all()[1].word.number, 2);
  editor.key(Key::kDigit7);
  EXPECT_EQ(editor.all()[1].word.number, 3);
  EXPECT_TRUE(editor.level().document().valid());
}

TEST(EditorKeysTest, FlipAndDelete) {
  TestEditor editor("-50 10 50 10 oneway\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kF);
  EXPECT_EQ(editor.all()[1], (EditedSegment{0, {50, 10}, {-50, 10}, {ElementKind::kOneway, 0}}));
  editor.key(Key::kDelete);
  EXPECT_EQ(editor.all().size(), 1U);
}

TEST(EditorKeysTest, TheWordOfTheNextSegmentIsChosen) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.key(Key::kX);
  editor.drag({0, {-50, 10}}, {0, {50, 10}});
  EXPECT_EQ(editor.all()[1].word.kind, ElementKind::kOneway);
}

TEST(EditorKeysTest, ShiftXIsTheWordBefore) {
  TestEditor editor;
  editor.key(Key::kX, false, true);
  EXPECT_EQ(editor.status().word.kind, kElementKinds.back());
  editor.key(Key::kX);
  EXPECT_EQ(editor.status().word.kind, std::nullopt);
  editor.key(Key::kX);
  editor.key(Key::kX, false, true);
  EXPECT_EQ(editor.status().word.kind, std::nullopt);
}

TEST(EditorKeysTest, TheStartIsTurned) {
  TestEditor editor;
  editor.key(Key::kT);
  editor.key(Key::kF);
  EXPECT_EQ(editor.level().document().level()->startAngle, Angle::degrees(90));
}

TEST(EditorKeysTest, TheGridIsChanged) {
  TestEditor editor;
  editor.key(Key::kPlus);
  EXPECT_EQ(editor.status().grid, 20);
  for (int i = 0; i < 9; ++i) editor.key(Key::kMinus);
  EXPECT_EQ(editor.status().grid, 1);
}

TEST(EditorKeysTest, ArrowsTurnTheSolidAndPagesZoom) {
  TestEditor editor;
  const glm::dvec3 before = editor.camera().back();
  editor.key(Key::kArrowLeft);
  EXPECT_GT(glm::distance(editor.camera().back(), before), 0.05);
  editor.key(Key::kArrowRight);
  EXPECT_LT(glm::distance(editor.camera().back(), before), 1e-9);
  const double far = glm::length(editor.camera().eye());
  editor.key(Key::kPageUp);
  EXPECT_LT(glm::length(editor.camera().eye()), far);
}

TEST(EditorKeysTest, EscapeEndsOneThingAfterAnother) {
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

TEST(EditorKeysTest, SavingAnInvalidLevelSaysSo) {
  TestEditor editor;
  editor.markSaved();
  EXPECT_EQ(editor.status().message, "saved");
  editor.key(Key::kT);
  editor.click({0, {0, -201}});
  editor.markSaved();
  EXPECT_EQ(editor.status().message.substr(0, 10), "saved, but");
}

TEST(EditorKeysTest, SaveAndLeaveWaitsForTheSave) {
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
}  // namespace platon::editor_keys_test
