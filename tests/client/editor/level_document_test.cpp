#include "client/editor/level_document.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "levels/solve/level_solver.h"
#include "tests/support/files.h"

namespace platon::level_document_test {
namespace {

const std::string kHead =
    "# title: A room\n# a comment\n\nHEXAHEDRON   # the solid\n0 0 -180 0  # start\n0  120 80\n480\n";
const std::string kFaces =
    "%  # face 0\n\n  -240.0 -200 240 -200   # floor\n# a wall\n10 20\t30 40 door 3\n%\n%\n5 6 7 8 oneway\n%\n%\n%\n";
const std::string kText = kHead + kFaces;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string withCarriageReturns(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

TEST(LevelDocumentTest, TheTextIsKeptByteForByte) {
  for (const std::string& text : {kText, withCarriageReturns(kText), "\xef\xbb\xbf" + kText, kText + "# end"})
    EXPECT_EQ(LevelDocument(text).text(), text);
}

TEST(LevelDocumentTest, SegmentsAreRead) {
  const LevelDocument document(kText);
  ASSERT_TRUE(document.valid());
  ASSERT_EQ(document.segments().size(), 3U);
  EXPECT_EQ(document.segments()[0], (EditedSegment{0, {-240, -200}, {240, -200}, {}}));
  EXPECT_EQ(document.segments()[1], (EditedSegment{0, {10, 20}, {30, 40}, {ElementKind::kDoor, {3}}}));
  EXPECT_EQ(document.segments()[2], (EditedSegment{2, {5, 6}, {7, 8}, {ElementKind::kOneway, {0}}}));
  EXPECT_EQ(document.textLineOf(1), 12);
}

// The document and the reader of levels find the same segments in the same text lines.
TEST(LevelDocumentTest, TheReaderOfLevelsAgrees) {
  std::vector<std::string> texts{kText, readText("tests/levels/picture/elements.level")};
  for (const std::string& file : shippedLevels()) texts.push_back(readText(file));
  for (const std::string& text : texts) {
    const LevelDocument document(text);
    ASSERT_TRUE(document.valid());
    const Level& level = *document.level();
    std::set<std::pair<int, int>> expected;
    for (int face = 0; face < static_cast<int>(level.positions.size()); ++face) {
      for (const TextPosition& at : level.positions[static_cast<std::size_t>(face)]) expected.emplace(face, at.line);
    }
    std::set<std::pair<int, int>> found;
    std::size_t words = 0;
    for (std::size_t i = 0; i < document.segments().size(); ++i) {
      found.emplace(document.segments()[i].face, document.textLineOf(i));
      words += document.segments()[i].word.kind ? 1 : 0;
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(words, level.elements.size());
  }
}

TEST(LevelDocumentTest, AnAddedSegmentComesAfterTheLastOneOfItsFace) {
  LevelDocument document(kText);
  document.add({0, {1, 2.5}, {-3, 4.12345}, {ElementKind::kKey, {7}}});
  EXPECT_EQ(document.text(), replaced(kText, "door 3\n", "door 3\n1 2.5 -3 4.1235 key 7\n"));
  document = LevelDocument(kText);
  document.add({5, {1, 2}, {3, 4}, {}});
  EXPECT_EQ(document.text(), kText + "1 2 3 4\n");
  document.check();
  EXPECT_TRUE(document.valid());
}

TEST(LevelDocumentTest, ATextWithoutALastLineEndGetsOne) {
  LevelDocument document(kText.substr(0, kText.size() - 1));
  document.add({5, {1, 2}, {3, 4}, {}});
  EXPECT_EQ(document.text(), kText + "1 2 3 4\n");
}

TEST(LevelDocumentTest, AReplacedSegmentKeepsItsCommentAndTheFormatOfEqualNumbers) {
  LevelDocument document(kText);
  document.replace(0, {0, {-240, -150}, {240, -200}, {ElementKind::kOneway, {0}}});
  EXPECT_EQ(document.text(),
            replaced(kText, "  -240.0 -200 240 -200   # floor", "  -240.0 -150 240 -200 oneway   # floor"));
  document = LevelDocument(kText);
  document.replace(1, {0, {10, 20}, {30, 40}, {}});
  EXPECT_EQ(document.text(), replaced(kText, "10 20\t30 40 door 3", "10 20\t30 40"));
}

TEST(LevelDocumentTest, ASegmentMovesToAnotherFace) {
  LevelDocument document(kText);
  document.replace(1, {2, {10, 20}, {30, 40}, {}});
  EXPECT_EQ(document.text(),
            replaced(replaced(kText, "10 20\t30 40 door 3\n", ""), "oneway\n", "oneway\n10 20 30 40\n"));
}

TEST(LevelDocumentTest, ErasingKeepsTheComment) {
  LevelDocument document(kText);
  document.erase(0);
  EXPECT_EQ(document.text(), replaced(kText, "  -240.0 -200 240 -200   # floor\n", "# floor\n"));
  document.erase(0);
  EXPECT_EQ(document.text(),
            replaced(replaced(kText, "  -240.0 -200 240 -200   # floor\n", "# floor\n"), "10 20\t30 40 door 3\n", ""));
}

// Segments erased in one pass leave what they leave when they are erased one by one, the last one first.
TEST(LevelDocumentTest, ErasingTogetherLeavesWhatErasingOneByOneLeaves) {
  for (const std::string& text : {kText, withCarriageReturns(kText), "\xef\xbb\xbf" + kText + "1 2 3 4 #\n5 6 7 8"}) {
    const std::size_t count = LevelDocument(text).segments().size();
    for (unsigned choice = 0; choice < 1U << count; ++choice) {
      LevelDocument oneByOne(text);
      LevelDocument together(text);
      std::vector<bool> chosen(count);
      for (std::size_t i = count; i-- > 0;) {
        chosen[i] = (choice >> i & 1U) != 0;
        if (chosen[i]) oneByOne.erase(i);
      }
      together.erase(chosen);
      EXPECT_EQ(together.text(), oneByOne.text()) << choice;
      EXPECT_EQ(together.segments(), oneByOne.segments()) << choice;
    }
  }
}

TEST(LevelDocumentTest, StartAndGoalChangeOnlyTheirTextLines) {
  LevelDocument document(kText);
  document.setStart({3, {10.5, -20}}, 90);
  document.setGoal({2, {0, 80}});
  const std::string expected = replaced(kText, "0 0 -180 0  # start", "3 10.5 -20 90  # start");
  EXPECT_EQ(document.text(), replaced(expected, "0  120 80", "2  0 80"));
}

TEST(LevelDocumentTest, TurningTheStartKeepsItsPlaceAsItIsWritten) {
  LevelDocument document(replaced(kText, "0 0 -180 0  # start", "0 0.10 -180 0  # start"));
  document.turnStart(90);
  EXPECT_EQ(document.text(), replaced(kText, "0 0 -180 0  # start", "0 0.10 -180 90  # start"));
}

TEST(LevelDocumentTest, LineEndsAreThoseOfTheText) {
  LevelDocument document(withCarriageReturns(kText));
  document.add({0, {1, 2}, {3, 4}, {}});
  document.setGoal({0, {121, 80}});
  const std::string expected = replaced(replaced(kText, "door 3\n", "door 3\n1 2 3 4\n"), "0  120 80", "0  121 80");
  EXPECT_EQ(document.text(), withCarriageReturns(expected));
}

TEST(LevelDocumentTest, AnInvalidEditIsKeptAndTheLastLevelToo) {
  LevelDocument document(kText);
  const std::shared_ptr<const Level> before = document.level();
  document.setStart({0, {0, -200}}, 0);
  document.check();
  EXPECT_FALSE(document.valid());
  EXPECT_EQ(document.level(), before);
  ASSERT_FALSE(document.diagnostics().empty());
  EXPECT_EQ(document.diagnostics().front().line, 5);
  document.setStart({0, {0, -180}}, 0);
  document.check();
  EXPECT_TRUE(document.valid());
  EXPECT_NE(document.level(), before);
}

TEST(CoordinateTextTest, HasNoMoreDecimalsThanAreNeeded) {
  EXPECT_EQ(coordinateText(12), "12");
  EXPECT_EQ(coordinateText(-0.5), "-0.5");
  EXPECT_EQ(coordinateText(-0.00001), "0");
  EXPECT_EQ(coordinateText(100.0625), "100.0625");
  EXPECT_EQ(coordinateText(1.0 / 3), "0.3333");
  EXPECT_EQ(coordinateText(-7.00049), "-7.0005");
}

TEST(NewLevel, ANewLevelIsValidWithoutWarningsAndSolved) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const auto solid = static_cast<SolidKind>(kind);
    const LevelResult result = loadLevel(newLevelText(solid, "My level"));
    ASSERT_TRUE(result.level) << result.diagnostics.front().message;
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(result.level->solid, solid);
    EXPECT_EQ(result.level->title, "My level");
    EXPECT_TRUE(LevelSolver(result.level).solve());
  }
}

TEST(NewLevel, TheTitleIsMadeOfTheFileName) {
  EXPECT_EQ(titleOf("02_half_turn.level"), "Half turn");
  EXPECT_EQ(titleOf("room"), "Room");
  EXPECT_EQ(titleOf("07.level"), "New level");
  EXPECT_EQ(titleOf("\xff\n.level"), "New level");
}

}  // namespace
}  // namespace platon::level_document_test
