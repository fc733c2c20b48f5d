#include "protocol/files/word_reader.h"

#include <gtest/gtest.h>

namespace platon::word_reader_test {
namespace {

TEST(WordReader, ReadsWordsBetweenSpacesAndTabs) {
  WordReader words("  ban \t Ann  2h ");
  EXPECT_EQ(words.peek(), "ban");
  EXPECT_EQ(words.next(), "ban");
  EXPECT_EQ(words.next(), "Ann");
  EXPECT_EQ(words.next(), "2h");
  EXPECT_EQ(words.next(), "");
  EXPECT_EQ(words.next(), "");
}

TEST(WordReader, TheRestIsEverythingLeftWithoutSpacesAroundIt) {
  WordReader words("say  hello  all \t");
  EXPECT_EQ(words.rest(), "say  hello  all");
  words.next();
  EXPECT_EQ(words.rest(), "hello  all");
  words.next();
  words.next();
  EXPECT_EQ(words.rest(), "");
}

TEST(WordReader, ColumnsCountBytesFromOne) {
  WordReader words("  a bc");
  EXPECT_EQ(words.column(), 3);
  words.next();
  EXPECT_EQ(words.column(), 5);
  words.next();
  EXPECT_EQ(words.column(), 7);
}

TEST(WordReader, AnEmptyLineHasNoWords) {
  for (const char* line : {"", " ", "\t \t"}) {
    WordReader words(line);
    EXPECT_EQ(words.peek(), "");
    EXPECT_EQ(words.rest(), "");
    EXPECT_EQ(words.next(), "");
  }
}

TEST(LineReader, RemembersWhereTheLastThingBegins) {
  LineReader line{WordReader("  a bc  d e ")};
  EXPECT_EQ(line.column, 1);
  EXPECT_EQ(line.next(), "a");
  EXPECT_EQ(line.column, 3);
  EXPECT_EQ(line.next(), "bc");
  EXPECT_EQ(line.column, 5);
  EXPECT_EQ(line.rest(), "d e");
  EXPECT_EQ(line.column, 9);
}

TEST(TextLines, AreNumberedAndEndWithLfOrCrLf) {
  TextLines lines("one\r\n\n # two\n\t\n# \n three\r");
  for (const std::string_view line : {"one", "", " # two", "\t", "# ", " three"}) {
    EXPECT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), line);
  }
  EXPECT_EQ(lines.number(), 6);
  EXPECT_FALSE(lines.next());
  EXPECT_FALSE(TextLines("").next());
}

TEST(TextLines, EntriesAreNeitherEmptyNorComments) {
  TextLines lines("\n# head\none\n \t\n\t# \r\n two\n\n");
  EXPECT_TRUE(lines.nextEntry());
  EXPECT_EQ(lines.line(), "one");
  EXPECT_EQ(lines.number(), 3);
  EXPECT_TRUE(lines.nextEntry());
  EXPECT_EQ(lines.line(), " two");
  EXPECT_EQ(lines.number(), 6);
  EXPECT_FALSE(lines.nextEntry());
}

}  // namespace
}  // namespace platon::word_reader_test
