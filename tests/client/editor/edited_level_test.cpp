#include "client/editor/edited_level.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/client/editor/test_editor.h"

namespace platon::edited_level_test {
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

TEST(EditedLevelTest, OfAnInvalidTextTheValidPartIsShown) {
  const std::string text = TestEditor::levelText("0 10 50 10\n0 300 50 300\n");
  EditedLevel level(text, true);
  EXPECT_FALSE(level.document().valid());
  EXPECT_EQ(level.text(), text);
  ASSERT_TRUE(level.document().level());
  ASSERT_EQ(level.faulty().size(), 1U);
  EXPECT_EQ(level.faulty().front().b, glm::dvec2(50, 300));
  EXPECT_FALSE(level.unsaved());
  level.edit([](LevelDocument& document) { document.erase(document.segments().size() - 1); });
  EXPECT_TRUE(level.document().valid());
  EXPECT_TRUE(level.faulty().empty());
}

TEST(EditedLevelTest, OfATextWithABlockedStartTheSolidIsShown) {
  EditedLevel level(TestEditor::levelText("-100 -200 -100 -150\n"), true);
  EXPECT_FALSE(level.document().valid());
  ASSERT_TRUE(level.document().level());
  EXPECT_EQ(level.faulty().size(), level.document().segments().size());
}

// It took a reading of the text for each segment: for these, hours.
TEST(EditedLevelTest, TheLargestInvalidLevelOpens) {
  constexpr std::string_view kOutside = "150 300 160 300  # outside the face\n";
  const std::size_t count = (kMaxLevelBytes - TestEditor::levelText().size()) / kOutside.size();
  std::string segments;
  for (std::size_t i = 0; i < count; ++i) segments += kOutside;
  const std::string text = TestEditor::levelText(segments);
  const EditedLevel level(text, true);
  EXPECT_FALSE(level.document().valid());
  EXPECT_EQ(level.text(), text);
  ASSERT_TRUE(level.document().level());
  EXPECT_EQ(level.document().segments().size(), count + 1);
  EXPECT_EQ(level.faulty().size(), EditedLevel::kMaxFaulty) << "all of them were drawn in every picture";
}

TEST(EditedLevelTest, AnInvalidHeaderHasNoLevel) { EXPECT_EQ(EditedLevel("CUBE\n", true).document().level(), nullptr); }

TEST(EditedLevelTest, AfterAForeignChangeNoTextIsSaved) {
  EditedLevel level(TestEditor::levelText(), true);
  addSegment(level);
  level.markUnsaved();
  EXPECT_TRUE(level.undo());
  EXPECT_TRUE(level.unsaved());
}

TEST(UndoHistoryTest, UndoAndRedoGoThroughTheTexts) {
  UndoHistory history;
  history.keep("a");
  history.keep("b");
  EXPECT_EQ(history.undo("c"), "b");
  EXPECT_EQ(history.undo("b"), "a");
  EXPECT_EQ(history.undo("a"), std::nullopt);
  EXPECT_EQ(history.redo("a"), "b");
  EXPECT_EQ(history.redo("b"), "c");
  EXPECT_EQ(history.redo("c"), std::nullopt);
}

TEST(UndoHistoryTest, AnEditForgetsWhatWasUndone) {
  UndoHistory history;
  history.keep("a");
  EXPECT_EQ(history.undo("b"), "a");
  history.keep("a");
  EXPECT_EQ(history.redo("c"), std::nullopt);
  EXPECT_EQ(history.undo("c"), "a");
}

TEST(UndoHistoryTest, TheOldestTextsAreForgotten) {
  UndoHistory history;
  for (std::size_t i = 0; i < UndoHistory::kMaxTexts + 5; ++i) history.keep(std::to_string(i));
  std::string text = "now";
  std::size_t count = 0;
  for (auto before = history.undo(text); before; before = history.undo(text)) {
    text = *before;
    ++count;
  }
  EXPECT_EQ(count, UndoHistory::kMaxTexts);
  EXPECT_EQ(text, "5");
}

TEST(UndoHistoryTest, TheBytesAreBounded) {
  UndoHistory history;
  const std::string large(UndoHistory::kMaxBytes / 2, 'x');
  for (int i = 0; i < 5; ++i) history.keep(large);
  EXPECT_TRUE(history.undo(""));
  EXPECT_TRUE(history.undo(""));
  EXPECT_FALSE(history.undo(""));
}

}  // namespace
}  // namespace platon::edited_level_test
