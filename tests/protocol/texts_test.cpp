#include "protocol/texts.h"

#include <gtest/gtest.h>

#include <string_view>

namespace platon::texts_test {
namespace {

TEST(Counted, HasThePluralUnlessThereIsOne) {
  EXPECT_EQ(counted(0, "line"), "0 lines");
  EXPECT_EQ(counted(1, "line"), "1 line");
  EXPECT_EQ(counted(2, "line"), "2 lines");
  EXPECT_EQ(counted(1, "press"), "1 press");
  EXPECT_EQ(counted(3, "press"), "3 presses");
}

TEST(Joined, HasTheSeparatorOnlyBetweenTheParts) {
  EXPECT_EQ(joined({}, ", "), "");
  EXPECT_EQ(joined({"a"}, ", "), "a");
  EXPECT_EQ(joined({"", "b", "", "d"}, ", "), ", b, , d");
}

TEST(JsonText, QuotesText) {
  EXPECT_EQ(jsonText(""), "\"\"");
  EXPECT_EQ(jsonText("First steps"), "\"First steps\"");
}

TEST(JsonText, EscapesQuotesAndBackslashes) {
  EXPECT_EQ(jsonText("a \"b\" \\ c"), "\"a \\\"b\\\" \\\\ c\"");
  EXPECT_EQ(jsonText("/"), "\"/\"") << "a slash needs no escape";
}

TEST(JsonText, EscapesControlCharacters) {
  EXPECT_EQ(jsonText(std::string_view("\0\t\n\x1f", 4)), "\"\\u0000\\u0009\\u000a\\u001f\"");
  EXPECT_EQ(jsonText("\x7f"), "\"\x7f\"") << "JSON allows U+007F";
}

TEST(JsonText, KeepsUtf8) { EXPECT_EQ(jsonText("Äpfel €😀"), "\"Äpfel €😀\""); }

}  // namespace
}  // namespace platon::texts_test
