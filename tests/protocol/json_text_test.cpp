#include "protocol/json_text.h"

#include <gtest/gtest.h>

#include <string_view>

namespace platon::json_text_test {
namespace {

TEST(JsonTextTest, QuotesText) {
  EXPECT_EQ(jsonText(""), "\"\"");
  EXPECT_EQ(jsonText("First steps"), "\"First steps\"");
}

TEST(JsonTextTest, EscapesQuotesAndBackslashes) {
  EXPECT_EQ(jsonText("a \"b\" \\ c"), "\"a \\\"b\\\" \\\\ c\"");
  EXPECT_EQ(jsonText("/"), "\"/\"") << "a slash needs no escape";
}

TEST(JsonTextTest, EscapesControlCharacters) {
  EXPECT_EQ(jsonText(std::string_view("\0\t\n\x1f", 4)), "\"\\u0000\\u0009\\u000a\\u001f\"");
  EXPECT_EQ(jsonText("\x7f"), "\"\x7f\"") << "JSON allows U+007F";
}

TEST(JsonTextTest, KeepsUtf8) { EXPECT_EQ(jsonText("Äpfel €😀"), "\"Äpfel €😀\""); }

}  // namespace
}  // namespace platon::json_text_test
