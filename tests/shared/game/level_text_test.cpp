#include "platon/game/level_text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace platon::level_text_test {
namespace {

std::vector<LevelLine> scan(std::string_view text) {
  std::vector<LevelLine> lines;
  LevelText reader(text);
  for (LevelLine line; reader.next(line);) lines.push_back(line);
  return lines;
}

std::string joined(const LevelLine& line) {
  std::string all;
  for (const LevelToken& token : line.tokens) all += std::to_string(token.column) + ":" + std::string(token.text) + " ";
  return all;
}

TEST(LevelTextTest, SplitsLinesAtLfAndCrLf) {
  const auto lines = scan("a b\r\n\n \tc\t d\nlast");
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(joined(lines[0]), "1:a 3:b ");
  EXPECT_EQ(joined(lines[1]), "");
  EXPECT_EQ(joined(lines[2]), "3:c 6:d ");
  EXPECT_EQ(joined(lines[3]), "1:last ");
  EXPECT_EQ(lines[3].number, 4);
  EXPECT_EQ(lines[0].end, 4);
  for (const LevelLine& line : lines) EXPECT_FALSE(line.fault);
}

TEST(LevelTextTest, CommentsRunToTheEndOfTheLine) {
  const auto lines = scan("1 2# 3 # 4\r\n#\n");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(joined(lines[0]), "1:1 3:2 ");
  EXPECT_EQ(lines[0].comment, "# 3 # 4");
  EXPECT_EQ(lines[0].commentColumn, 4);
  EXPECT_EQ(lines[1].comment, "#");
}

TEST(LevelTextTest, EmptyTextHasNoLines) {
  EXPECT_TRUE(scan("").empty());
  EXPECT_TRUE(scan("\xef\xbb\xbf").empty());
}

TEST(LevelTextTest, SkipsAByteOrderMarkOnlyAtTheBeginning) {
  const auto first = scan(
      "\xef\xbb\xbf"
      "abc\n");
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(joined(first[0]), "1:abc ");
  EXPECT_EQ(joined(scan("abc\n\xef\xbb\xbf"
                        "d")[1]),
            "1:\xef\xbb\xbf"
            "d ");
}

TEST(LevelTextTest, TheLinesTogetherAreTheText) {
  for (const std::string text :
       {"", "\n", "a", "a\r\n\r\n b # c\n", "\xef\xbb\xbf\n1\n", "\xef\xbb\xbf# a\nb\r", "\x01\n%\x80 2"}) {
    std::string all;
    for (const LevelLine& line : scan(text)) all += line.text;
    EXPECT_EQ(all, text);
  }
}

std::string rolesOf(std::string_view text) {
  std::string roles;
  for (const LevelLine& line : scan(text)) {
    roles += std::string_view(".hms")[static_cast<std::size_t>(line.role)];
    if (line.role == LevelLine::Role::kFaceMark || line.role == LevelLine::Role::kSegment)
      roles += std::to_string(line.face);
    roles += ' ';
  }
  return roles;
}

TEST(LevelTextTest, ALineIsPartOfTheHeaderAFaceMarkOrASegment) {
  EXPECT_EQ(rolesOf("# a\nCUBE\n\n1\n2\n3\n%\n4\n\n5 # b\n% c\n6\n"), ". h . h h h m0 s0 . s0 m1 s1 ");
  EXPECT_EQ(rolesOf("1\n2\n3\n4\n5\n%\n%\n"), "h h h h s-1 m0 m1 ") << "before the first face mark";
  EXPECT_EQ(rolesOf("1\n2\n%\n3\n"), "h h m0 s0 ") << "a face mark ends the header";
  EXPECT_EQ(rolesOf("%\x01\n1\n2\n3\n% \x80\n%%\n%\n"), "h h h h s-1 s-1 m0 ") << "what cannot be read is no face mark";
}

TEST(LevelTextTest, FindsControlCharactersAtTheirPosition) {
  const auto lines = scan(std::string_view("ab\0c\n\x1b[1m # \x07\n1 2 # \x7f\n3\r4\n# \xc2\x85\n", 30));
  ASSERT_EQ(lines.size(), 5u);
  const std::string tail = ": only tabs and line ends (LF or CR LF) are allowed";
  const std::vector<std::pair<int, std::string>> expected{
      {3, "0x00"}, {1, "0x1b"}, {7, "0x7f"}, {2, "0x0d"}, {3, "0x85"}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_TRUE(lines[i].fault) << i;
    EXPECT_EQ(lines[i].fault->column, expected[i].first);
    EXPECT_EQ(lines[i].fault->message, "control character " + expected[i].second + tail);
    EXPECT_EQ(lines[i].isUnreadable(), i != 2 && i != 4) << "those are in the comment";
  }
  EXPECT_EQ(joined(lines[2]), "1:1 3:2 ");
}

TEST(LevelTextTest, AcceptsUtf8InComments) {
  EXPECT_FALSE(scan("# title: \xc3\x84pfel \xe2\x82\xac \xf0\x9f\x8d\x8e \xef\xbf\xbf\n")[0].fault);
}

TEST(LevelTextTest, FindsMalformedUtf8) {
  for (const char* bytes : {"\x80", "\xc3", "\xc3(", "\xc0\xaf", "\xe0\x80\x80", "\xe2\x82", "\xed\xa0\x80",
                            "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff", "\xfe"}) {
    const std::string text = "# a" + std::string(bytes);
    const auto lines = scan(text);
    ASSERT_TRUE(lines[0].fault);
    EXPECT_EQ(lines[0].fault->column, 4);
    EXPECT_EQ(lines[0].fault->message, "invalid UTF-8: save the file as UTF-8");
  }
}

TEST(LevelTextTest, TheEndOfTheTextIsAfterTheLastByteOfItsLastLine) {
  LevelText text("ab\ncd # e\n");
  EXPECT_EQ(text.lines(), 1);
  EXPECT_EQ(text.endOfLine(), 1);
  for (LevelLine line; text.next(line);) {
  }
  EXPECT_EQ(text.lines(), 2);
  EXPECT_EQ(text.endOfLine(), 7);
}

}  // namespace
}  // namespace platon::level_text_test
