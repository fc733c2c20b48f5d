#include "client/gl/text_painter.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/gl_context.h"
#include "client/gl/render_target.h"

namespace platon::text_painter_test {
namespace {

// Adds glyphs until the texture is full and returns the first code point that no longer fits.
char32_t fill(GlyphAtlas& atlas, char32_t first) {
  constexpr char32_t kLimit = 0x8000;
  while (first < kLimit && atlas.find(first) != nullptr) ++first;
  EXPECT_LT(first, kLimit);
  return first;
}

class GlyphAtlasTest : public testing::Test {
 protected:
  Offscreen context_;
  Font font_;
  GlyphAtlas atlas_{font_};
};

TEST_F(GlyphAtlasTest, AnEntryHasTheShapeOfTheGlyph) {
  const Font::Glyph glyph = font_.glyph(U'A');
  const GlyphAtlas::Entry* entry = atlas_.find(U'A');
  ASSERT_NE(entry, nullptr);
  EXPECT_FALSE(entry->blank);
  EXPECT_EQ(entry->low, glyph.low);
  EXPECT_EQ(entry->high, glyph.high);
  EXPECT_FLOAT_EQ((entry->highTexel.x - entry->lowTexel.x) * GlyphAtlas::kSize, static_cast<float>(glyph.width));
  EXPECT_FLOAT_EQ((entry->lowTexel.y - entry->highTexel.y) * GlyphAtlas::kSize, static_cast<float>(glyph.height));
  EXPECT_EQ(takeGlErrors(), "");
}

TEST_F(GlyphAtlasTest, ASpaceIsBlank) {
  const GlyphAtlas::Entry* entry = atlas_.find(U' ');
  ASSERT_NE(entry, nullptr);
  EXPECT_TRUE(entry->blank);
}

TEST_F(GlyphAtlasTest, AGlyphIsAddedOnce) { EXPECT_EQ(atlas_.find(U'A'), atlas_.find(U'A')); }

TEST_F(GlyphAtlasTest, GlyphsDoNotOverlapAndLieInTheTexture) {
  std::vector<const GlyphAtlas::Entry*> drawn;
  for (char32_t point = U'!'; point < U'!' + 300; ++point) {
    const GlyphAtlas::Entry* entry = atlas_.find(point);
    ASSERT_NE(entry, nullptr);
    if (entry->blank) continue;
    EXPECT_GE(entry->lowTexel.x, 0);
    EXPECT_GE(entry->highTexel.y, 0);
    EXPECT_LE(entry->highTexel.x, 1);
    EXPECT_LE(entry->lowTexel.y, 1);
    for (const GlyphAtlas::Entry* other : drawn) {
      const bool beside = entry->lowTexel.x >= other->highTexel.x || other->lowTexel.x >= entry->highTexel.x;
      const bool above = entry->highTexel.y >= other->lowTexel.y || other->highTexel.y >= entry->lowTexel.y;
      ASSERT_TRUE(beside || above) << "code point " << static_cast<int>(point);
    }
    drawn.push_back(entry);
  }
  EXPECT_GT(drawn.size(), 200U);
}

TEST_F(GlyphAtlasTest, HoldsTheVisibleNamesOf64PlayersAtOnce) {
  constexpr int kPlayers = 64;
  constexpr int kVisibleLength = 20;
  const char32_t end = fill(atlas_, U'!');
  EXPECT_GT(end - U'!', kPlayers * kVisibleLength + 100);
}

TEST_F(GlyphAtlasTest, AFullAtlasHasRoomAgainAfterClear) {
  const char32_t refused = fill(atlas_, U'!');
  EXPECT_NE(atlas_.find(U'!'), nullptr) << "present glyphs stay";
  EXPECT_EQ(atlas_.find(refused), nullptr);
  atlas_.clear();
  const GlyphAtlas::Entry* entry = atlas_.find(refused);
  ASSERT_NE(entry, nullptr);
  EXPECT_FALSE(entry->blank);
  EXPECT_EQ(entry->lowTexel.x * GlyphAtlas::kSize, 1);
  EXPECT_EQ(entry->highTexel.y * GlyphAtlas::kSize, 1);
}

// What lies there was once undefined, and showed as specks in the text of some drivers.
TEST_F(GlyphAtlasTest, ABorderIsEmptyWhateverWasThereBefore) {
  constexpr std::size_t kSide = GlyphAtlas::kSize;
  for (const char32_t wide : std::u32string(U"MWQ@")) atlas_.find(wide);
  atlas_.clear();
  const GlyphAtlas::Entry entry = *atlas_.find(U'm');
  std::vector<std::uint8_t> texels(kSide * kSide);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, texels.data());
  const auto texel = [](float part) { return static_cast<std::size_t>(part * float{kSide}); };
  const std::size_t left = texel(entry.lowTexel.x);
  const std::size_t right = texel(entry.highTexel.x);
  const std::size_t first = texel(entry.highTexel.y);
  const std::size_t last = texel(entry.lowTexel.y);
  const auto brightest = [&](std::size_t row, std::size_t from, std::size_t to) {
    const auto begin = texels.begin() + static_cast<std::ptrdiff_t>(row * kSide);
    return *std::max_element(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to));
  };
  EXPECT_EQ(brightest(first - 1, left - 1, right + 1), 0);
  EXPECT_EQ(brightest(last, left - 1, right + 1), 0);
  for (std::size_t row = first; row < last; ++row) {
    EXPECT_EQ(brightest(row, left - 1, left), 0) << row;
    EXPECT_EQ(brightest(row, right, right + 1), 0) << row;
  }
  EXPECT_GT(brightest((first + last) / 2, left, right), 128);
}

constexpr std::uint32_t kWidth = 400;
constexpr std::uint32_t kHeight = 60;

std::string utf8Of(char32_t point) {
  std::string bytes;
  bytes += static_cast<char>(0xE0 | point >> 12);
  bytes += static_cast<char>(0x80 | (point >> 6 & 0x3F));
  bytes += static_cast<char>(0x80 | (point & 0x3F));
  return bytes;
}

// A name of 20 glyphs that no other `index` has.
std::string hostileName(int index) {
  std::string name;
  for (int i = 0; i < 20; ++i) name += utf8Of(static_cast<char32_t>(0x1000 + 20 * index + i));
  return name;
}

// The largest difference of a colour component.
int difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

class TextPainterTest : public testing::Test {
 protected:
  // White text on black. `before` is added in the same flush, outside the picture.
  Image draw(TextPainter& painter, const std::string& text, const std::string& before = "") {
    target_.bindSampled();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    target_.resolve();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    painter.add(before, {0, -5000}, {32, 0}, {0, 32}, {1, 1, 1, 1});
    painter.add(text, {10, 20}, {32, 0}, {0, 32}, {1, 1, 1, 1});
    painter.flush(glm::ortho(0.0F, float{kWidth}, 0.0F, float{kHeight}), 0);
    EXPECT_EQ(takeGlErrors(), "");
    return target_.read();
  }
  Image drawWithNewPainter(const std::string& text) {
    TextPainter painter(font_);
    return draw(painter, text);
  }

  Offscreen context_;
  Font font_;
  RenderTarget target_{kWidth, kHeight, 1};
};

TEST_F(TextPainterTest, TextIsWhereItIsAdded) {
  const Image image = drawWithNewPainter("I");
  const auto bright = [&](int x, int y) {
    return image.pixels[3 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x))] > 200;
  };
  const int stem = 10 + static_cast<int>(font_.advance(U'I') * 32 / 2);
  EXPECT_TRUE(bright(stem, static_cast<int>(kHeight) - 20 - 10));
  EXPECT_FALSE(bright(stem, static_cast<int>(kHeight) - 20 + 4)) << "below the baseline";
  EXPECT_FALSE(bright(stem + 20, static_cast<int>(kHeight) - 20 - 10)) << "to the right";
}

TEST_F(TextPainterTest, FlushRemovesAllText) {
  TextPainter painter(font_);
  draw(painter, "Text");
  const Image empty = draw(painter, "");
  EXPECT_EQ(*std::max_element(empty.pixels.begin(), empty.pixels.end()), 0);
}

TEST_F(TextPainterTest, TwoHundredHostileNamesOneAfterAnotherDoNotBlankTheText) {
  TextPainter painter(font_);
  for (int i = 0; i < 200; ++i) draw(painter, hostileName(i));
  EXPECT_LE(difference(draw(painter, "Platon"), drawWithNewPainter("Platon")), 2);
}

TEST_F(TextPainterTest, TwoHundredHostileNamesAtOnceDoNotBlankTheText) {
  TextPainter painter(font_);
  std::string all;
  for (int i = 0; i < 200; ++i) all += hostileName(i);
  EXPECT_LE(difference(draw(painter, "Platon", all), drawWithNewPainter("Platon")), 2);
  EXPECT_LE(difference(draw(painter, hostileName(7), "Platon" + all), drawWithNewPainter(hostileName(7))), 2);
}

}  // namespace

}  // namespace platon::text_painter_test
