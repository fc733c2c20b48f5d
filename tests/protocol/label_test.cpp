#include "protocol/label.h"

#include <gtest/gtest.h>

#include <string>

namespace platon {
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

}  // namespace
}  // namespace platon
