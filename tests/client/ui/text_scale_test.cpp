#include "client/ui/text_scale.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "client/ui/setting_table.h"
#include "levels/drawing/typeface.h"

namespace platon::text_scale_test {
namespace {

constexpr std::uint32_t kHeights[] = {1, 180, 360, 480, 720, 1080, 2160};

SettingNumber uiScale() {
  const std::span<const Setting> table = settingTable();
  const auto found = std::find_if(table.begin(), table.end(), [](const Setting& it) { return it.name == "text-size"; });
  return std::get<SettingNumber>(found->value);
}

TEST(TextScale, NoTextIsUnderTheSmallestSizeInAnyPictureAtAnyScale) {
  for (const std::uint32_t height : kHeights) {
    for (double scale = uiScale().min; scale <= uiScale().max; scale += 0.05) {
      const float pixels = kSmallestText * textScale(scale, height) * static_cast<float>(height) / Overlay::kHeight;
      EXPECT_GT(pixels, kSmallestTextPixels - 0.001F) << height << " " << scale;
    }
  }
}

TEST(TextScale, IsThatOfTheSettingsWhereTextsAreLargeEnough) {
  EXPECT_FLOAT_EQ(textScale(0.75, 720), 0.75F);
  EXPECT_FLOAT_EQ(textScale(1, 540), 1);
  EXPECT_FLOAT_EQ(textScale(1.75, 2160), 1.75F);
  EXPECT_FLOAT_EQ(textScale(1, 360), 1.5F);
}

// The letters of the typeface are as large as those of a font of this size, whose capitals are 0.7 of it.
TEST(TextScale, TheSmallestLettersAreThoseOf11Pixels) {
  EXPECT_GE(kSmallestTextPixels * Typeface::kCapitalHeight, 11 * 0.7F);
}

TEST(TextScale, AllLengthsAreMultiplied) {
  Overlay overlay;
  overlay.panels.push_back({{1, 2}, {3, 4}, 5, {}});
  overlay.texts.push_back({{6, 7}, 8, {}, "text"});
  const Overlay scaled = scaledBy(overlay, 2);
  EXPECT_EQ(scaled.panels[0].low, glm::vec2(2, 4));
  EXPECT_EQ(scaled.panels[0].high, glm::vec2(6, 8));
  EXPECT_EQ(scaled.panels[0].radius, 10);
  EXPECT_EQ(scaled.texts[0].place, glm::vec2(12, 14));
  EXPECT_EQ(scaled.texts[0].size, 16);
}

}  // namespace
}  // namespace platon::text_scale_test
