#include "client/editor/editor_tools.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/client/editor/test_editor.h"
#include "tests/support/sample_word.h"

namespace platon::editor_tools_test {
namespace {

Key keyOf(char digit) { return static_cast<Key>(static_cast<int>(Key::kDigit0) + digit - '0'); }

TEST(EditorToolsTest, DrawingAddsASegmentOnTheGrid) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.drag({0, {-48, 12}}, {0, {53, 8}});
  ASSERT_EQ(editor.all().size(), 2U);
  EXPECT_EQ(editor.all()[1], (EditedSegment{0, {-50, 10}, {50, 10}, {}}));
  EXPECT_TRUE(editor.level().unsaved());
}

TEST(EditorToolsTest, AltDrawsFreelyAndShiftStraight) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.drag({0, {-48.25, 12.5}}, {0, {53.5, 41.75}}, true);
  ASSERT_EQ(editor.all().size(), 2U);
  EXPECT_NEAR(editor.all()[1].b.x, 53.5, 0.001);
  editor.drag({0, {-48, 112}}, {0, {53, 130}}, false, true);
  EXPECT_EQ(editor.all()[2], (EditedSegment{0, {-50, 110}, {50, 110}, {}}));
}

TEST(EditorToolsTest, AClickDrawsNothing) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.click({0, {-48, 12}});
  EXPECT_FALSE(editor.level().unsaved());
}

TEST(EditorToolsTest, ErasingRemovesTheSegmentUnderThePointer) {
  TestEditor editor("-50 10 50 10\n");
  editor.key(Key::kE);
  editor.click({0, {0, 12}});
  ASSERT_EQ(editor.all().size(), 1U);
  editor.click({0, {0, 100}});
  EXPECT_EQ(editor.all().size(), 1U);
}

TEST(EditorToolsTest, AnEndAndAWholeSegmentAreMoved) {
  TestEditor editor("-50 10 50 10\n");
  editor.drag({0, {48, 10}}, {0, {81, 62}});
  EXPECT_EQ(editor.all()[1], (EditedSegment{0, {-50, 10}, {80, 60}, {}}));
  editor.drag({0, {15, 35}}, {0, {26, 76}});
  EXPECT_EQ(editor.all()[1], (EditedSegment{0, {-40, 50}, {90, 100}, {}}));
}

TEST(EditorToolsTest, AMovedSegmentKeepsItsComment) {
  TestEditor editor;
  editor.drag({0, {0, -200}}, {0, {0, -210}});
  EXPECT_NE(editor.level().text().find("-200 -210 200 -210  # floor\n"), std::string::npos);
}

// The piece on face 1 comes before face 4 in the text.
TEST(EditorToolsTest, AMovedSegmentStaysSelectedWhenAPieceOnAnotherFaceIsAdded) {
  TestEditor editor;
  for (int i = 0; i < 6; ++i) editor.key(Key::kArrowRight);
  editor.drag({0, {195, -200}}, {1, {-200, -100}});
  ASSERT_EQ(editor.all().size(), 2U);
  EXPECT_EQ(editor.all()[1].face, 1);
  editor.key(Key::kDelete);
  ASSERT_EQ(editor.all().size(), 1U);
  EXPECT_EQ(editor.all()[0].face, 1) << "the piece on face 0 was selected";
}

TEST(EditorToolsTest, TheWordToolGoesThroughAllWords) {
  TestEditor editor("-50 10 50 10\n");
  editor.key(Key::kW);
  for (const ElementKind kind : kElementKinds) {
    editor.click({0, {0, 10}});
    EXPECT_EQ(editor.all()[1].word.kind, kind);
  }
  editor.click({0, {0, 10}});
  EXPECT_EQ(editor.all()[1].word.kind, std::nullopt);
}

TEST(EditorToolsTest, StartAndGoalArePlaced) {
  TestEditor editor;
  editor.key(Key::kT);
  editor.click({0, {51, 102}});
  editor.click({0, {-51, -184}});
  EXPECT_EQ(editor.level().document().level()->start, Point(-50 * 1024, -180 * 1024)) << "not onto the floor";
  editor.click({0, {51, 102}});
  editor.key(Key::kG);
  editor.click({0, {-51, 102}});
  ASSERT_TRUE(editor.level().document().valid());
  const Level& level = *editor.level().document().level();
  EXPECT_EQ(level.start, Point(50 * 1024, 100 * 1024));
  EXPECT_EQ(level.goal, Point(-50 * 1024, 100 * 1024));
  EXPECT_EQ(level.startAngle, Angle());
}

TEST(EditorToolsTest, AStartInAWallIsKeptAndReported) {
  TestEditor editor;
  editor.key(Key::kT);
  editor.click({0, {0, -201}});
  EXPECT_FALSE(editor.level().document().valid());
  EXPECT_EQ(editor.status().error.substr(0, 14), "test.level:3:3");
  EXPECT_TRUE(editor.scene().stage);
}

TEST(EditorToolsTest, EveryToolHasAKey) {
  TestEditor editor;
  for (const EditToolFacts& facts : kEditTools) {
    editor.key(facts.key);
    EXPECT_EQ(editor.status().tool, facts.tool);
  }
}

TEST(EditorToolsTest, DigitsSetTheNumberOfTheSelectedSegment) {
  TestEditor editor("-50 10 50 10 door 3\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit1);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 1) << "a number of its own";
  editor.key(Key::kDigit2);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 12);
  editor.key(Key::kDigit7);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 7);
  editor.key(Key::kDigit8);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 8) << "there is no door 78";
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit2);
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit1);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 1) << "not 21: a click ends the number";
}

TEST(EditorToolsTest, AnUpHasTheNumberOfAnEdge) {
  TestEditor editor("-50 10 50 10 up 0\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kDigit2);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 2);
  editor.key(Key::kDigit7);
  EXPECT_EQ(editor.all()[1].word.numbers[0], 3);
  EXPECT_TRUE(editor.level().document().valid());
}

constexpr int kEdges = 4;  // of a face of the cube

// The kinds with numbers, each with its largest ones: "up 3" …
std::vector<ElementWord> largestNumbers() {
  std::vector<ElementWord> words;
  for (const ElementKind kind : kElementKinds) {
    const auto last = static_cast<std::uint16_t>(rangeOf(kind, kEdges).last);
    if (numbersOf(kind) > 0) words.push_back({kind, last, numbersOf(kind) > 1 ? last : std::uint16_t{0}});
  }
  return words;
}

void typeNumbers(TestEditor& editor, const ElementWord& word) {
  for (const char digit : std::to_string(word.number)) editor.key(keyOf(digit));
  if (numbersOf(word.kind) < 2) return;
  editor.key(Key::kComma);
  for (const char digit : std::to_string(word.openTicks)) editor.key(keyOf(digit));
}

// Chooses the word of the next segment.
void choose(TestEditor& editor, const ElementWord& word) {
  while (editor.status().word.kind != word.kind) editor.key(Key::kX);
  typeNumbers(editor, word);
}

// Draws a segment with each word that follows this one, and without a word.
void expectValidAfter(const ElementWord& word, bool back) {
  TestEditor editor;
  editor.key(Key::kD);
  choose(editor, word);
  ASSERT_EQ(editor.status().word, (SegmentWord{word.kind, {word.number, word.openTicks}}));
  for (std::size_t i = 0; i <= kElementKinds.size(); ++i) {
    editor.key(Key::kX, false, back);
    const double height = 20.0 * static_cast<double>(i);
    editor.drag({0, {-50, height}}, {0, {50, height}});
    EXPECT_TRUE(editor.level().document().valid()) << "after " << word.text() << ": " << editor.status().error;
  }
  EXPECT_EQ(editor.all().size(), kElementKinds.size() + 2) << "the floor, and a segment with each word or none";
}

TEST(EditorToolsTest, AChangeOfTheWordKeepsTheNumberValid) {
  for (const ElementWord& word : largestNumbers()) {
    expectValidAfter(word, false);
    expectValidAfter(word, true);
  }
}

TEST(EditorToolsTest, EachNumberThatAWordMayHaveIsTypedAndNoOther) {
  for (const ElementWord& word : largestNumbers()) {
    TestEditor editor("-50 10 50 10 " + sampleWord(word.kind, 0).text() + "\n");
    editor.click({0, {0, 10}});
    typeNumbers(editor, word);
    EXPECT_EQ(editor.all()[1].word, (SegmentWord{word.kind, {word.number, word.openTicks}})) << word.text();
    for (const char digit : std::string("9876543210123456789")) {
      editor.key(keyOf(digit));
      EXPECT_TRUE(editor.level().document().valid()) << word.text() << ": " << editor.status().error;
    }
  }
}

TEST(EditorToolsTest, TheNumberOfTheNextSegmentIsValidOnAnotherSolid) {
  TestEditor editor;
  choose(editor, {ElementKind::kUp, 3, 0});
  ASSERT_EQ(editor.status().word.numbers[0], 3);
  editor.reload("TETRAHEDRON\n0 0 -50 0\n0 50 -50\n480\n%\n%\n%\n%\n");
  ASSERT_EQ(editor.scene().stage->mesh.faces(), 4) << editor.status().error;
  EXPECT_EQ(editor.status().word.kind, ElementKind::kUp);
  EXPECT_LT(editor.status().word.numbers[0], 3);
}

TEST(EditorToolsTest, FlipAndDelete) {
  TestEditor editor("-50 10 50 10 oneway\n");
  editor.click({0, {0, 10}});
  editor.key(Key::kF);
  EXPECT_EQ(editor.all()[1], (EditedSegment{0, {50, 10}, {-50, 10}, {ElementKind::kOneway, {}}}));
  editor.key(Key::kDelete);
  EXPECT_EQ(editor.all().size(), 1U);
}

TEST(EditorToolsTest, TheWordOfTheNextSegmentIsChosen) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.key(Key::kX);
  editor.drag({0, {-50, 10}}, {0, {50, 10}});
  EXPECT_EQ(editor.all()[1].word.kind, ElementKind::kOneway);
}

TEST(EditorToolsTest, ShiftXIsTheWordBefore) {
  TestEditor editor;
  editor.key(Key::kX, false, true);
  EXPECT_EQ(editor.status().word.kind, kElementKinds.back());
  editor.key(Key::kX);
  EXPECT_EQ(editor.status().word.kind, std::nullopt);
  editor.key(Key::kX);
  editor.key(Key::kX, false, true);
  EXPECT_EQ(editor.status().word.kind, std::nullopt);
}

TEST(EditorToolsTest, TheStartIsTurned) {
  TestEditor editor;
  editor.key(Key::kT);
  editor.key(Key::kF);
  EXPECT_EQ(editor.level().document().level()->startAngle, Angle::degrees(90));
}

TEST(EditorToolsTest, TheGridIsChanged) {
  TestEditor editor;
  editor.key(Key::kPlus);
  EXPECT_EQ(editor.status().grid, 20);
  for (int i = 0; i < 9; ++i) editor.key(Key::kMinus);
  EXPECT_EQ(editor.status().grid, 1);
}

}  // namespace
}  // namespace platon::editor_tools_test
