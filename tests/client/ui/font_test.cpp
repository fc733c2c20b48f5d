#include "client/ui/font.h"

#include <algorithm>
#include <cstddef>
#include <random>

#include <gtest/gtest.h>

namespace platon::font_test {
namespace {

TEST(Font, HasTheGlyphsOfTheGame) {
  const Font font;
  const Font::Glyph missing = font.glyph(U'\uE000');
  for (const char32_t point : std::u32string(U"09AZaz✓★←→↑‹›…é")) {
    const Font::Glyph glyph = font.glyph(point);
    ASSERT_EQ(glyph.distances.size(), static_cast<std::size_t>(glyph.width * glyph.height));
    EXPECT_NE(glyph.distances, missing.distances) << static_cast<unsigned>(point);
    EXPECT_GT(*std::max_element(glyph.distances.begin(), glyph.distances.end()), Font::kOnOutline);
    EXPECT_LT(*std::min_element(glyph.distances.begin(), glyph.distances.end()), Font::kOnOutline);
    EXPECT_GT(font.advance(point), 0);
  }
  EXPECT_EQ(font.glyph(U' ').width, 0);
}

TEST(Font, CapitalsHaveTheStatedHeight) {
  const Font font;
  const Font::Glyph glyph = font.glyph(U'H');
  std::ptrdiff_t highest = glyph.height;
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(glyph.distances.size()); ++i) {
    if (glyph.distances[static_cast<std::size_t>(i)] >= Font::kOnOutline) highest = std::min(highest, i / glyph.width);
  }
  const float rows = static_cast<float>(highest) / static_cast<float>(glyph.height);
  EXPECT_NEAR(glyph.high.y + rows * (glyph.low.y - glyph.high.y), Font::kCapitalHeight, 0.04);
}

TEST(FittedText, WhatFitsIsUnchanged) {
  const Font font;
  EXPECT_EQ(fittedText("Resume", font, font.width("Resume")), "Resume");
  EXPECT_EQ(fittedText("", font, 0), "");
}

TEST(FittedText, WhatIsTooLongEndsWithAnEllipsisAndIsAsLongAsPossible) {
  const Font font;
  EXPECT_EQ(fittedText("Füßchen", font, font.width("Füß…")), "Füß…");
  EXPECT_EQ(fittedText("Füßchen", font, font.width("Fü…") + 0.001F), "Fü…");
  EXPECT_EQ(fittedText("Resume", font, 0.01F), "") << "not even one letter fits";
}

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
}  // namespace platon::font_test
