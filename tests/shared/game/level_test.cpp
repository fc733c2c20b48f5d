#include "platon/game/level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace platon::level_test {
namespace {

// The sample of docs/level_format.md.
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
  ASSERT_EQ(level->segments.size(), 6u);
  EXPECT_EQ(level->segments[0], (std::vector<Segment>{{{-245760, -204800}, {102400, -204800}}}));
  for (std::size_t face = 1; face < 6; ++face) EXPECT_TRUE(level->segments[face].empty());
  EXPECT_EQ(level->title, "A sample");
  EXPECT_EQ(level->author, "Somebody");
  EXPECT_EQ(level->text, kSample);
  EXPECT_EQ(level->world.geometry().parts.size(), 6u);
  EXPECT_TRUE(level->world.entities().empty());
}

TEST(LevelTest, LineEndsTabsBlankLinesAndCommentsChangeNothing) {
  const auto plain = load(kSample);
  for (const std::string& text :
       {replaced(kSample, "\n", "\r\n"), replaced(kSample, "\n", "\n\n"), replaced(kSample, " ", " \t "),
        replaced(kSample, "\n", " # a comment\n"), "\xef\xbb\xbf" + std::string(kSample),
        std::string(kSample).substr(0, std::string(kSample).size() - 1), replaced(kSample, "%", "\t%  #")}) {
    const auto level = load(text);
    ASSERT_NE(level, nullptr) << text;
    EXPECT_EQ(level->start, plain->start);
    EXPECT_EQ(level->goal, plain->goal);
    EXPECT_EQ(level->segments, plain->segments);
    EXPECT_NE(level->hash, plain->hash) << "the hash covers the whole text";
  }
  EXPECT_EQ(load(kSample)->hash, plain->hash);
}

TEST(LevelTest, TitleAndAuthorPrecedeTheFirstLine) {
  const auto level = load(replaced(kSample, "480\n", "480\n# title: Too late\n"));
  EXPECT_EQ(level->title, "A sample");
  EXPECT_EQ(load(replaced(kSample, "# title: A sample", "#title:\tA # sample "))->title, "A # sample");
  EXPECT_EQ(load(replaced(kSample, "# title:", "# name:"))->title, "");
}

TEST(LevelTest, LinesAreClippedAtTheEdges) {
  const auto level = load(replaced(kSample, "-240 -200 100 -200", "-1000 -200 1000 -200"));
  EXPECT_EQ(level->segments[0], (std::vector<Segment>{{{-245760, -204800}, {245760, -204800}}}));
}

TEST(LevelTest, DecimalsAreRoundedToTheNearestSubunit) {
  const auto level = load(replaced(kSample, "-240 -200 100 -200", "0.0004 0.0005 -0.0005 100.4999"));
  EXPECT_EQ(level->segments[0], (std::vector<Segment>{{{0, 1}, {-1, 102912}}}));
}

TEST(LevelTest, RotationIsInDegreesCounterClockwise) {
  const auto turned = [](const std::string& degrees) {
    return load(replaced(kSample, "-150 0", "-150 " + degrees))->startAngle;
  };
  EXPECT_EQ(turned("90"), Angle(9000));
  EXPECT_EQ(turned("-90"), Angle(27000));
  EXPECT_EQ(turned("360"), Angle());
  EXPECT_EQ(turned("37"), Angle(3700));
}

TEST(LevelTest, TheStartMayTouchALineButNotOverlapIt) {
  // The line is at y = -200, the bottom edge of the player 11.77 units below its centre.
  EXPECT_EQ(loadLevel(replaced(kSample, "0 -100 -150 0", "0 -100 -188 0")).level != nullptr, true);
  const auto result = loadLevel(replaced(kSample, "0 -100 -150 0", "0 -100 -189 0"));
  EXPECT_EQ(result.level, nullptr);
  EXPECT_EQ(messages(result),
            "4:3: the start is blocked: a line or a corner overlaps the player there; move the start or the line\n");
}

TEST(LevelTest, TheStartIsCheckedAcrossEdges) {
  // Face 1 is to the right of face 0; its wall is 5 units behind the edge.
  const std::string wall = replaced(kSample, "%\n%\n", "%\n-235 -240 -235 240\n%\n");
  EXPECT_NE(loadLevel(replaced(wall, "0 -100 -150 0", "0 222 0 0")).level, nullptr);
  const auto result = loadLevel(replaced(wall, "0 -100 -150 0", "0 235 0 0"));
  EXPECT_EQ(messages(result),
            "4:3: the start is blocked: a line or a corner overlaps the player there; move the start or the line\n");
}

TEST(LevelTest, TheGoalMayBeOnTheEdgeButNotOutside) {
  EXPECT_NE(load(replaced(kSample, "3 120 80", "3 240 -240")), nullptr);
  const auto result = loadLevel(replaced(kSample, "3 120 80", "3 240.001 80"));
  EXPECT_EQ(messages(result), "5:3: the goal is outside its face: move it inside\n");
}

TEST(LevelTest, WarningsAreNotErrors) {
  const auto result = loadLevel(replaced(kSample, "-240 -200 100 -200",
                                         "-240 -200 100 -200\n5 5 5 5\n1 2 3 4\n3 4 1 2 # again\n"
                                         "-240 -239.96 -239.96 -240\n240 0 300 0"));
  ASSERT_NE(result.level, nullptr);
  EXPECT_EQ(messages(result),
            "9:1: the line has no length: it blocks as a point\n"
            "11:1: duplicate of line 10: remove one of the two\n"
            "12:1: the line has no effect: it is in a corner of its face, which blocks already; remove it\n"
            "13:1: the line only touches its face: move it inside, or remove it\n");
  EXPECT_TRUE(std::none_of(result.diagnostics.begin(), result.diagnostics.end(), [](auto& one) { return one.error; }));
  EXPECT_EQ(result.level->segments[0].size(), 6u);
}

// A level that the server or the client would have to carry through every tick.
TEST(LevelTest, TooManyLinesInOnePlaceAreAnError) {
  std::string lines;
  for (int i = 0; i < 600; ++i)
    lines += "0 " + std::to_string(-40 - i % 30) + " 9 " + std::to_string(-40 - i / 30) + "\n";
  const auto result = loadLevel(replaced(kSample, "-240 -200 100 -200\n", lines));
  EXPECT_EQ(result.level, nullptr);
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(
      format("sample", result.diagnostics[0]),
      "sample:550:1: error: too many lines in one place: more than 512 touch the square of 80 x 80 units round -36 "
      "-84 of face 0; remove some or spread them out");
}

TEST(LevelTest, ALineThatFillsALevelWithWarningsDoesNotHideTheError) {
  std::string lines;
  for (int i = 0; i < 200000; ++i) lines += "0 -50 9 -50\n";
  const auto result = loadLevel(replaced(kSample, "-240 -200 100 -200\n", lines));
  EXPECT_EQ(result.level, nullptr);
  EXPECT_TRUE(std::any_of(result.diagnostics.begin(), result.diagnostics.end(), [](const Diagnostic& one) {
    return one.error && one.line == 520 && one.message.starts_with("too many lines in one place");
  }));
}

LevelResult levelWith(const std::string& lines) {
  return loadLevel("HEXAHEDRON\n0 0 0 0\n0 0 0\n480\n%\n" + lines + "%\n%\n%\n%\n%\n");
}

TEST(LevelTest, ACheckpointMayBeNearWhatNeverBlocks) {
  const std::string checkpoint = "90 90 110 110 checkpoint\n";
  EXPECT_NE(levelWith(checkpoint + "90 110 110 90 key 1\n95 90 110 110 checkpoint\n").level, nullptr);
  for (const char* word : {"", "oneway", "up 0", "hazard", "door 1", "plate 1"})
    EXPECT_EQ(levelWith(checkpoint + "90 110 110 90 " + word + "\n").level, nullptr) << word;
}

// The largest distance at which a line is refused is between that of the edges and that of the vertices of the ball.
TEST(LevelTest, ACheckpointIsFreeForAPlayerAtAnyAngle) {
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const double radians = degrees * 3.14159265 / 180;
    const auto isAllowed = [&](double distance) {
      char line[96];
      const double x = 100 + distance * std::cos(radians);
      const double y = 100 + distance * std::sin(radians);
      std::snprintf(line, sizeof line, "%.3f %.3f %.3f %.3f\n", x, y, x + 9 * std::cos(radians),
                    y + 9 * std::sin(radians));
      return levelWith("90 100 110 100 checkpoint\n" + std::string(line)).level != nullptr;
    };
    EXPECT_FALSE(isAllowed(12.2)) << degrees;
    EXPECT_TRUE(isAllowed(12.6)) << degrees;
  }
}

TEST(LevelTest, AllLinesTogetherAreLimited) {
  const auto levelOf = [](int count) {
    std::string text = "HEXAHEDRON\n0 0 0 0\n0 0 0\n65536\n%\n";
    for (int i = 0; i < count; ++i) {
      const std::string y = std::to_string(100 + 20 * i);
      text += "-32768 " + y + " 32768 " + y + "\n";
    }
    return loadLevel(text + "%\n%\n%\n%\n%\n");
  };
  EXPECT_NE(levelOf(1024).level, nullptr);
  const auto result = levelOf(1030);
  EXPECT_EQ(result.level, nullptr);
  EXPECT_EQ(messages(result), "1030:1: the lines are together longer than 67108864 units: remove or shorten some\n");
}

TEST(LevelTest, ReadsTheLongestTextAndNoLonger) {
  std::string text = std::string(kSample) + "#";
  text.resize(kMaxLevelBytes, '.');
  EXPECT_NE(load(text), nullptr);
  const auto result = loadLevel(text + ".");
  EXPECT_EQ(result.level, nullptr);
  EXPECT_EQ(messages(result), "1:1: the level file is longer than 4194304 bytes\n");
}

TEST(LevelTest, TheNumberOfDiagnosticsIsBounded) {
  const auto result = loadLevel(std::string(kMaxLevelBytes / 2, '\n') + std::string(kMaxLevelBytes / 2, '\0'));
  EXPECT_EQ(result.level, nullptr);
  std::string text;
  while (text.size() < kMaxLevelBytes - 2) text += "%\n";
  const auto many = loadLevel("HEXAHEDRON\n0 0 0 0\n0 0 0\n480\n" + text.substr(0, text.size() - 100));
  EXPECT_EQ(many.diagnostics.size(), Diagnostics::kMax + 1);
  EXPECT_EQ(many.diagnostics.back().message, "too many errors and warnings; fix these first");
  EXPECT_TRUE(many.diagnostics.back().error);
}

}  // namespace
}  // namespace platon::level_test
