#include "shared/game/level_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace platon::level_text_test {
namespace {

struct Scanned {
  std::vector<LevelLine> lines;
  std::vector<Diagnostic> diagnostics;
};

Scanned scan(std::string_view text) {
  Scanned scanned;
  Diagnostics diagnostics;
  LevelText reader(text, diagnostics);
  for (LevelLine line; reader.next(line);) scanned.lines.push_back(line);
  scanned.diagnostics = diagnostics.take();
  return scanned;
}

std::string joined(const LevelLine& line) {
  std::string all;
  for (const LevelToken& token : line.tokens) all += std::to_string(token.column) + ":" + std::string(token.text) + " ";
  return all;
}

TEST(LevelTextTest, SplitsLinesAtLfAndCrLf) {
  const auto scanned = scan("a b\r\n\n \tc\t d\nlast");
  ASSERT_EQ(scanned.lines.size(), 4u);
  EXPECT_EQ(joined(scanned.lines[0]), "1:a 3:b ");
  EXPECT_EQ(joined(scanned.lines[1]), "");
  EXPECT_EQ(joined(scanned.lines[2]), "3:c 6:d ");
  EXPECT_EQ(joined(scanned.lines[3]), "1:last ");
  EXPECT_EQ(scanned.lines[3].number, 4);
  EXPECT_EQ(scanned.lines[0].end, 4);
  EXPECT_TRUE(scanned.diagnostics.empty());
}

TEST(LevelTextTest, CommentsRunToTheEndOfTheLine) {
  const auto scanned = scan("1 2# 3 # 4\n#\n");
  ASSERT_EQ(scanned.lines.size(), 2u);
  EXPECT_EQ(joined(scanned.lines[0]), "1:1 3:2 ");
  EXPECT_EQ(scanned.lines[0].comment, "# 3 # 4");
  EXPECT_EQ(scanned.lines[0].commentColumn, 4);
  EXPECT_EQ(scanned.lines[1].comment, "#");
}

TEST(LevelTextTest, EmptyTextHasNoLines) {
  EXPECT_TRUE(scan("").lines.empty());
  EXPECT_TRUE(scan("\xef\xbb\xbf").lines.empty());
}

TEST(LevelTextTest, SkipsAByteOrderMarkOnlyAtTheBeginning) {
  const auto first = scan(
      "\xef\xbb\xbf"
      "abc\n");
  ASSERT_EQ(first.lines.size(), 1u);
  EXPECT_EQ(joined(first.lines[0]), "1:abc ");
  EXPECT_EQ(joined(scan("abc\n\xef\xbb\xbf"
                        "d")
                       .lines[1]),
            "1:\xef\xbb\xbf"
            "d ");
}

TEST(LevelTextTest, ReportsControlCharactersAtTheirPosition) {
  const auto scanned = scan(std::string_view("ab\0c\n\x1b[1m # \x07\n1 2 # \x7f\n3\r4\n# \xc2\x85\n", 30));
  ASSERT_EQ(scanned.diagnostics.size(), 5u);
  const std::string tail = ": only tabs and line ends (LF or CR LF) are allowed";
  EXPECT_EQ(scanned.diagnostics[0], (Diagnostic{1, 3, true, "control character 0x00" + tail}));
  EXPECT_EQ(scanned.diagnostics[1], (Diagnostic{2, 1, true, "control character 0x1b" + tail}));
  EXPECT_EQ(scanned.diagnostics[2], (Diagnostic{3, 7, true, "control character 0x7f" + tail}));
  EXPECT_EQ(scanned.diagnostics[3], (Diagnostic{4, 2, true, "control character 0x0d" + tail}));
  EXPECT_EQ(scanned.diagnostics[4], (Diagnostic{5, 3, true, "control character 0x85" + tail}));
  EXPECT_TRUE(scanned.lines[0].invalid);
  EXPECT_TRUE(scanned.lines[0].tokens.empty());
  EXPECT_FALSE(scanned.lines[2].invalid) << "the control character is in the comment";
  EXPECT_EQ(joined(scanned.lines[2]), "1:1 3:2 ");
}

TEST(LevelTextTest, AcceptsUtf8InComments) {
  EXPECT_TRUE(scan("# title: \xc3\x84pfel \xe2\x82\xac \xf0\x9f\x8d\x8e \xef\xbf\xbf\n").diagnostics.empty());
}

TEST(LevelTextTest, ReportsMalformedUtf8) {
  for (const char* bytes : {"\x80", "\xc3", "\xc3(", "\xc0\xaf", "\xe0\x80\x80", "\xe2\x82", "\xed\xa0\x80",
                            "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff", "\xfe"}) {
    const auto scanned = scan("# a" + std::string(bytes));
    ASSERT_EQ(scanned.diagnostics.size(), 1u);
    EXPECT_EQ(scanned.diagnostics[0], (Diagnostic{1, 4, true, "invalid UTF-8: save the file as UTF-8"}));
  }
}

TEST(LevelTextTest, TheEndOfTheTextIsAfterTheLastByteOfItsLastLine) {
  Diagnostics diagnostics;
  LevelText text("ab\ncd # e\n", diagnostics);
  EXPECT_EQ(text.lines(), 1);
  EXPECT_EQ(text.endOfLine(), 1);
  for (LevelLine line; text.next(line);) {
  }
  EXPECT_EQ(text.lines(), 2);
  EXPECT_EQ(text.endOfLine(), 7);
}

}  // namespace
}  // namespace platon::level_text_test
