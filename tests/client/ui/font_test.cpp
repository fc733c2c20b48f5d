#include "client/ui/font.h"

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

namespace platon {
namespace {

TEST(Font, DecodesValidText) {
  EXPECT_EQ(codePointsOf("aé€😀"), U"aé€😀");
  EXPECT_EQ(codePointsOf(""), U"");
}

TEST(Font, ReplacesEveryInvalidByte) {
  EXPECT_EQ(codePointsOf("a\x80z"), U"a\uFFFDz");
  EXPECT_EQ(codePointsOf("\xC3"), U"\uFFFD");
  EXPECT_EQ(codePointsOf("\xC3("), U"\uFFFD(");
  EXPECT_EQ(codePointsOf("\xC0\xAF"), U"\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(codePointsOf("\xE0\x80\xAF"), U"\uFFFD\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(codePointsOf("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(codePointsOf("\xF4\x90\x80\x80"), U"\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond Unicode";
  EXPECT_EQ(codePointsOf("\xFF"), U"\uFFFD");
}

TEST(Font, OmitsControlCharacters) { EXPECT_EQ(codePointsOf("a\n\x7F\xC2\x85z"), U"az"); }

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

TEST(Font, WidthIsTheSumOfTheAdvances) {
  const Font font;
  EXPECT_NEAR(font.width("Ab"), font.advance(U'A') + font.advance(U'b'), 1e-6);
  EXPECT_GT(font.width("WW"), font.width("ii"));
}

}  // namespace
}  // namespace platon
