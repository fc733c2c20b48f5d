#include "platon/game/level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "shared/game/level_reader.h"

namespace platon {
namespace {

// The level file of the format's description.
constexpr const char* kSample = R"(# title: A sample
# author:  Somebody
HEXAHEDRON
0 -100 -150 0
3 120 80
480
%
-240 -200 100 -200
%
%
%
%
%
)";

std::string messages(const LevelResult& result) {
  std::string all;
  for (const Diagnostic& one : result.diagnostics) {
    all += std::to_string(one.line) + ":" + std::to_string(one.column) + ": " + one.message + "\n";
  }
  return all;
}

std::shared_ptr<const Level> load(const std::string& text) {
  const LevelResult result = loadLevel(text);
  EXPECT_EQ(messages(result), "");
  return result.level;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(LevelTest, ReadsTheSample) {
  const auto level = load(kSample);
  ASSERT_NE(level, nullptr);
  EXPECT_EQ(level->solid, SolidKind::kHexahedron);
  EXPECT_EQ(level->faceSize, 480);
  EXPECT_EQ(level->startFace, 0u);
  EXPECT_EQ(level->start, Point(-102400, -153600));
  EXPECT_EQ(level->startAngle, Angle());
  EXPECT_EQ(level->goalFace, 3u);
  EXPECT_EQ(level->goal, Point(122880, 81920));
  ASSERT_EQ(level->lines.size(), 6u);
  EXPECT_EQ(level->lines[0], (std::vector<Segment>{{{-245760, -204800}, {102400, -204800}}}));
  for (std::size_t face = 1; face < 6; ++face) EXPECT_TRUE(level->lines[face].empty());
  EXPECT_EQ(level->title, "A sample");
  EXPECT_EQ(level->author, "Somebody");
  EXPECT_EQ(level->text, kSample);
  EXPECT_EQ(level->world.geometry().parts.size(), 6u);
  EXPECT_TRUE(level->world.entities().empty());
}

TEST(LevelTest, LineEndsTabsBlankLinesAndCommentsDoNotMatter) {
  const auto plain = load(kSample);
  for (const std::string& text :
       {replaced(kSample, "\n", "\r\n"), replaced(kSample, "\n", "\n\n"), replaced(kSample, " ", " \t "),
        replaced(kSample, "\n", " # a comment\n"), "\xef\xbb\xbf" + std::string(kSample),
        std::string(kSample).substr(0, std::string(kSample).size() - 1), replaced(kSample, "%", "\t%  #")}) {
    const auto level = load(text);
    ASSERT_NE(level, nullptr) << text;
    EXPECT_EQ(level->start, plain->start);
    EXPECT_EQ(level->goal, plain->goal);
    EXPECT_EQ(level->lines, plain->lines);
    EXPECT_NE(level->hash, plain->hash) << "the hash is that of the text";
  }
  EXPECT_EQ(load(kSample)->hash, plain->hash);
}

TEST(LevelTest, NamesCountOnlyBeforeTheFirstLine) {
  const auto level = load(replaced(kSample, "480\n", "480\n# title: Too late\n"));
  EXPECT_EQ(level->title, "A sample");
  EXPECT_EQ(load(replaced(kSample, "# title: A sample", "#title:\tA # sample "))->title, "A # sample");
  EXPECT_EQ(load(replaced(kSample, "# title:", "# name:"))->title, "");
}

TEST(LevelTest, LinesAreCutAtTheEdges) {
  const auto level = load(replaced(kSample, "-240 -200 100 -200", "-1000 -200 1000 -200"));
  EXPECT_EQ(level->lines[0], (std::vector<Segment>{{{-245760, -204800}, {245760, -204800}}}));
}

TEST(LevelTest, DecimalsAreRoundedToTheNearestSubunit) {
  const auto level = load(replaced(kSample, "-240 -200 100 -200", "0.0004 0.0005 -0.0005 100.4999"));
  EXPECT_EQ(level->lines[0], (std::vector<Segment>{{{0, 1}, {-1, 102912}}}));
}

TEST(LevelTest, RotationIsOfTheUpAndMayBeNegative) {
  const auto turned = [](const std::string& degrees) {
    return load(replaced(kSample, "-150 0", "-150 " + degrees))->startAngle;
  };
  EXPECT_EQ(turned("90"), Angle(9000));
  EXPECT_EQ(turned("-90"), Angle(27000));
  EXPECT_EQ(turned("360"), Angle());
  EXPECT_EQ(turned("37"), Angle(3700));
}

TEST(LevelTest, StartMayTouchALineButNotOverlapIt) {
  // The ball has 12 units to its lowest vertices.
  EXPECT_EQ(loadLevel(replaced(kSample, "0 -100 -150 0", "0 -100 -188 0")).level != nullptr, true);
  const auto result = loadLevel(replaced(kSample, "0 -100 -150 0", "0 -100 -189 0"));
  EXPECT_EQ(result.level, nullptr);
  EXPECT_EQ(messages(result), "4:3: the start is not free: a line or a corner overlaps the player there\n");
}

TEST(LevelTest, StartIsCheckedOverTheEdgesToo) {
  // Face 1 lies to the right of face 0; a wall there, 5 units behind the edge.
  const std::string wall = replaced(kSample, "%\n%\n", "%\n-235 -240 -235 240\n%\n");
  EXPECT_NE(loadLevel(replaced(wall, "0 -100 -150 0", "0 222 0 0")).level, nullptr);
  const auto result = loadLevel(replaced(wall, "0 -100 -150 0", "0 235 0 0"));
  EXPECT_EQ(messages(result), "4:3: the start is not free: a line or a corner overlaps the player there\n");
}

TEST(LevelTest, GoalMayLieOnTheEdgeButNotBeyond) {
  EXPECT_NE(load(replaced(kSample, "3 120 80", "3 240 -240")), nullptr);
  const auto result = loadLevel(replaced(kSample, "3 120 80", "3 240.001 80"));
  EXPECT_EQ(messages(result), "5:3: the goal lies outside its face\n");
}

TEST(LevelTest, WarningsDoNotRefuseALevel) {
  const auto result = loadLevel(replaced(kSample, "-240 -200 100 -200",
                                         "-240 -200 100 -200\n5 5 5 5\n1 2 3 4\n3 4 1 2 # again\n"
                                         "-240 -239.96 -239.96 -240\n240 0 300 0"));
  ASSERT_NE(result.level, nullptr);
  EXPECT_EQ(messages(result),
            "9:1: a line without length: it blocks as a point\n"
            "11:1: the same line as in line 10\n"
            "12:1: the line lies wholly in a corner of its face, which is blocked already\n"
            "13:1: hardly anything of the line is on its face\n");
  EXPECT_TRUE(std::none_of(result.diagnostics.begin(), result.diagnostics.end(), [](auto& one) { return one.error; }));
  EXPECT_EQ(result.level->lines[0].size(), 6u);
}

TEST(LevelTest, TextOfTheMostBytesIsReadAndOneMoreIsNot) {
  std::string text = std::string(kSample) + "#";
  text.resize(kMaxLevelBytes, '.');
  EXPECT_NE(load(text), nullptr);
  const auto result = loadLevel(text + ".");
  EXPECT_EQ(result.level, nullptr);
  EXPECT_EQ(messages(result), "1:1: the text has more than 4194304 bytes\n");
}

TEST(LevelTest, MostLinesAreReadAndOneMoreIsNot) {
  std::string text = "HEXAHEDRON\n0 0 0 0\n0 0 0\n1000\n%\n";
  for (std::size_t i = 0; i < LevelReader::kMaxLines; ++i) {
    text += "-500 " + std::to_string(20 + i % 450) + " 500 " + std::to_string(20 + i / 450) + "\n";
  }
  const std::string rest = "%\n%\n%\n%\n%\n";
  EXPECT_NE(load(text + rest), nullptr);
  const auto result = loadLevel(text + "0 20 0 30\n0 20 0 40\n" + rest);
  EXPECT_EQ(messages(result), "200006:1: more than 200000 lines: take some away\n");
}

TEST(LevelTest, FaultsWithoutEndFillNoMemory) {
  const auto result = loadLevel(std::string(kMaxLevelBytes / 2, '\n') + std::string(kMaxLevelBytes / 2, '\0'));
  EXPECT_EQ(result.level, nullptr);
  std::string text;
  while (text.size() < kMaxLevelBytes - 2) text += "%\n";
  const auto many = loadLevel("HEXAHEDRON\n0 0 0 0\n0 0 0\n480\n" + text.substr(0, text.size() - 100));
  EXPECT_EQ(many.diagnostics.size(), Diagnostics::kMax + 1);
  EXPECT_EQ(many.diagnostics.back().message, "more faults follow, which are not listed: mend these first");
  EXPECT_TRUE(many.diagnostics.back().error);
}

}  // namespace
}  // namespace platon
