#include "client/editor/undo_history.h"

#include <gtest/gtest.h>

#include <string>

namespace platon::undo_history_test {
namespace {

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
}  // namespace platon::undo_history_test
