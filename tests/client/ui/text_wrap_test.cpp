#include "client/ui/text_wrap.h"

#include <gtest/gtest.h>

#include <random>

namespace platon::text_wrap_test {
namespace {

using Lines = std::vector<std::string>;

const Font& font() {
  static const Font font;
  return font;
}

float widthOf(const std::string& text) { return font().width(text); }

TEST(TextWrap, ATextThatFitsIsOneLine) {
  EXPECT_EQ(wrapText("one two", font(), widthOf("one two")), Lines{"one two"});
  EXPECT_EQ(wrapText("", font(), 10), Lines{});
}

TEST(TextWrap, BreaksAtSpaces) {
  EXPECT_EQ(wrapText("one two three", font(), widthOf("one two") * 1.01F), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapText("one two", font(), widthOf("one two") * 0.99F), (Lines{"one", "two"}));
}

TEST(TextWrap, AWordThatIsTooWideIsBrokenBetweenCodePoints) {
  EXPECT_EQ(wrapText("жжжжж a", font(), widthOf("жж") * 1.01F), (Lines{"жж", "жж", "ж", "a"}));
  EXPECT_EQ(wrapText("жж", font(), 0), (Lines{"ж", "ж"}));
}

TEST(TextWrap, TheWordAfterABrokenOneContinuesItsLine) {
  EXPECT_EQ(wrapText("MMMMM i", font(), widthOf("MMM") * 1.01F), (Lines{"MMM", "MM i"}));
}

// Nothing of a text is lost but spaces, and no line that could be broken is too wide.
TEST(TextWrap, KeepsEveryCharacterWithinTheWidth) {
  std::mt19937 random(5);
  const Lines parts{"a", "W", "ж", "世", " ", " ", "i"};
  for (int i = 0; i < 500; ++i) {
    std::string text;
    for (std::size_t size = random() % 60; size > 0; --size) text += parts[random() % parts.size()];
    std::string visible = text;
    std::erase(visible, ' ');
    std::string all;
    for (const std::string& line : wrapText(text, font(), 3)) {
      EXPECT_LE(widthOf(line), 3) << line;
      all += line;
    }
    std::erase(all, ' ');
    EXPECT_EQ(all, visible);
  }
}

}  // namespace
}  // namespace platon::text_wrap_test
