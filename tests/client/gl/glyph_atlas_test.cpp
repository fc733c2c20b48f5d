#include "client/gl/glyph_atlas.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_loader.h"
#include "client/gl/offscreen.h"

namespace platon::glyph_atlas_test {
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

}  // namespace
}  // namespace platon::glyph_atlas_test
