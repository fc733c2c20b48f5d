#include "client/gl/glyph_atlas.h"

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
  EXPECT_EQ(entry->lowTexel.x, 0);
  EXPECT_EQ(entry->highTexel.y, 0);
}

}  // namespace
}  // namespace platon::glyph_atlas_test
