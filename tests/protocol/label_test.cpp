#include "protocol/label.h"

#include <gtest/gtest.h>

#include <string>

namespace platon::label_test {
namespace {

using namespace std::string_literals;

TEST(Label, AcceptsTextThatCanBeShown) {
  for (const auto& text :
       {""s, "Ann"s, "a b"s, "Łukasz"s, "世界"s, "\xf0\x9f\x8e\xb2"s, "\xef\xbf\xbd"s, "\xf4\x8f\xbf\xbf"s}) {
    EXPECT_TRUE(isLabel(text, 32)) << text;
  }
}

TEST(Label, RefusesControlCharactersLineBreaksAndDirectionMarks) {
  for (const auto& text : {"a\nb"s, "\x1b[31m"s, "a\0b"s, "\x7f"s, "\xc2\x85"s, "\xe2\x80\xa8"s, "\xe2\x80\xae"s,
                           "\xe2\x81\xa6"s, "\xd8\x9c"s, "\t"s}) {
    EXPECT_FALSE(isLabel(text, 32)) << testing::PrintToString(text);
  }
}

TEST(Label, RefusesInvalidUtf8) {
  for (const auto& text : {"\x80"s, "\xc3"s, "\xc3("s, "\xc0\xaf"s, "\xe0\x80\xaf"s, "\xed\xa0\x80"s,
                           "\xf0\x80\x80\xaf"s, "\xf4\x90\x80\x80"s, "\xf8\x88\x80\x80\x80"s, "\xe4\xb8"s, "\xff"s}) {
    EXPECT_FALSE(isLabel(text, 32)) << testing::PrintToString(text);
  }
}

TEST(Label, LimitsTheNumberOfBytes) {
  EXPECT_TRUE(isLabel("1234", 4));
  EXPECT_FALSE(isLabel("12345", 4));
  EXPECT_FALSE(isLabel("世界", 5));
}

TEST(Label, VisibleTextIsKept) {
  for (const auto& text : {""s, "Ann"s, "a b"s, "Łukasz"s, "世界"s, "\U0001f3b2"s, "e\u0301"s, "नमस्ते"s, "ß!?"s}) {
    EXPECT_EQ(visibleLabel(text), text);
  }
}

TEST(Label, InvisibleCharactersAreLeftOut) {
  for (const auto& invisible :
       {"\u200b"s, "\u200d"s, "\u00ad"s, "\ufe0f"s, "\ufeff"s, "\u2060"s, "\u3164"s, "\u115f"s, "\uffa0"s, "\u180e"s,
        "\U000e0041"s, "\ufffc"s, "\ue000"s, "\U0010ffff"s, "\u202e"s, "\u034f"s, "\x7f"s}) {
    EXPECT_EQ(visibleLabel("A" + invisible + "nn"), "Ann") << testing::PrintToString(invisible);
    EXPECT_EQ(visibleLabel(invisible), "") << testing::PrintToString(invisible);
  }
}

TEST(Label, RunsOfSpacesBecomeOne) {
  EXPECT_EQ(visibleLabel("  a \u3000\u00a0 b\u2003"), "a b");
  EXPECT_EQ(visibleLabel("a \u200b b"), "a b");
  EXPECT_EQ(visibleLabel("\u2800 "), "");
}

TEST(Label, CombiningCharactersNeedACharacterBefore) {
  EXPECT_EQ(visibleLabel("\u0301\u20dd"), "");
  EXPECT_EQ(visibleLabel("\u0301a\u0301"), "a\u0301");
  EXPECT_EQ(visibleLabel("a \u0301b"), "a b");
}

TEST(Label, LabelsThatLookAlikeHaveTheSameKey) {
  const auto alike = [](const std::string& a, const std::string& b) { return lookAlikeKey(a) == lookAlikeKey(b); };
  EXPECT_TRUE(alike("Ann", " aNN\u200b"));
  EXPECT_TRUE(alike("ŁUKASZ", "łukasz"));
  EXPECT_TRUE(alike("ΣΟΦΟΣ", "σοφος")) << "a final sigma is a sigma";
  EXPECT_TRUE(alike("ЯНА", "яна"));
  EXPECT_TRUE(alike("STRAẞE", "straße"));
  EXPECT_FALSE(alike("Ann", "Anna"));
  EXPECT_FALSE(alike("A nn", "Ann"));
  EXPECT_FALSE(alike("Ān", "An"));
}

}  // namespace
}  // namespace platon::label_test
