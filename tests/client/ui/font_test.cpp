#include "client/ui/font.h"

#include <algorithm>
#include <cstddef>

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

}  // namespace
}  // namespace platon::font_test
