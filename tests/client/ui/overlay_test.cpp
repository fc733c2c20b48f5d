#include "client/ui/overlay.h"

#include <algorithm>
#include <span>
#include <variant>

#include <gtest/gtest.h>
#include <glm/vec3.hpp>

#include "client/ui/setting_table.h"
#include "client/ui/settings.h"
#include "levels/drawing/typeface.h"

namespace platon::overlay_test {
namespace {

SettingNumber uiScale() {
  const std::span<const Setting> table = settingTable();
  const auto found = std::find_if(table.begin(), table.end(), [](const Setting& it) { return it.name == "text-size"; });
  return std::get<SettingNumber>(found->value);
}

using namespace overlay_colours;

constexpr std::uint32_t kHeights[] = {1, 180, 360, 480, 720, 1080, 2160};

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

TEST(HighContrastOverlay, PanelsAreOpaqueAndDarkOnesBlack) {
  Overlay overlay;
  for (const glm::vec4 colour : {kPanel, kSelected}) overlay.panels.push_back({{10, 10}, {90, 40}, 5, colour});
  raiseContrast(overlay);
  EXPECT_EQ(overlay.panels[0].colour, glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(overlay.panels[1].colour, glm::vec4(glm::vec3(kSelected), 1));
}

TEST(HighContrastOverlay, WhatDimsTheWholePictureStillDoes) {
  Overlay overlay;
  overlay.panels.push_back({{0, 0}, {1280, Overlay::kHeight}, 0, {0, 0, 0, 0.5F}});
  const glm::vec4 before = overlay.panels[0].colour;
  raiseContrast(overlay);
  EXPECT_EQ(overlay.panels[0].colour, before);
}

TEST(HighContrastOverlay, TextsAreAsBrightAsTheyCanBe) {
  Overlay overlay;
  for (const glm::vec4 colour : {kSoft, kWarning, glm::vec4(0.05F, 0.05F, 0.08F, 1)})
    overlay.texts.push_back({{0, 0}, 16, colour, "text"});
  raiseContrast(overlay);
  EXPECT_EQ(overlay.texts[0].colour.b, 1);
  EXPECT_GT(overlay.texts[0].colour.r, kSoft.r);
  EXPECT_EQ(overlay.texts[1].colour, kWarning);
  EXPECT_EQ(overlay.texts[2].colour.r, 0.05F) << "dark text on a bright panel";
}

const Font& font() {
  static const Font font;
  return font;
}

constexpr glm::vec4 kColour(0.1F, 0.2F, 0.3F, 0.4F);
constexpr float kSize = 20;

TEST(OverlayWriter, LeftRightAndCentredTextSharesItsBaseline) {
  OverlayWriter writer(font());
  writer.left("Text", {100, 50}, kSize, kColour);
  writer.right("Text", {100, 50}, kSize, kColour);
  writer.centred("Text", {100, 50}, kSize, kColour);
  const float width = font().width("Text") * kSize;
  EXPECT_FLOAT_EQ(writer.width("Text", kSize), width);
  const Overlay overlay = writer.take();
  ASSERT_EQ(overlay.texts.size(), 3U);
  EXPECT_FLOAT_EQ(overlay.texts[0].place.x, 100);
  EXPECT_FLOAT_EQ(overlay.texts[1].place.x, 100 - width);
  EXPECT_FLOAT_EQ(overlay.texts[2].place.x, 100 - width / 2);
  for (const Overlay::Text& text : overlay.texts) {
    EXPECT_EQ(text.content, "Text");
    EXPECT_EQ(text.place.y, 50);
    EXPECT_EQ(text.size, kSize);
    EXPECT_EQ(text.colour, kColour);
  }
}

TEST(OverlayWriter, NoTextIsSmallerThanTheSmallest) {
  OverlayWriter writer(font());
  writer.left("Text", {100, 50}, kSmallestText / 2, kColour);
  EXPECT_FLOAT_EQ(writer.width("Text", kSmallestText / 2), font().width("Text") * kSmallestText);
  EXPECT_EQ(writer.take().texts[0].size, kSmallestText);
}

TEST(OverlayWriter, PanelsKeepTheirOrder) {
  OverlayWriter writer(font());
  writer.panel({1, 2}, {3, 4}, 5, kColour);
  writer.panel({6, 7}, {8, 9}, 10, kColour);
  const Overlay overlay = writer.take();
  ASSERT_EQ(overlay.panels.size(), 2U);
  EXPECT_EQ(overlay.panels[0].low, glm::vec2(1, 2));
  EXPECT_EQ(overlay.panels[0].high, glm::vec2(3, 4));
  EXPECT_EQ(overlay.panels[0].radius, 5);
  EXPECT_EQ(overlay.panels[0].colour, kColour);
  EXPECT_EQ(overlay.panels[1].low, glm::vec2(6, 7));
}

TEST(OverlayWriter, APillEnclosesItsText) {
  OverlayWriter writer(font());
  writer.pill("Text", {300, 200}, kSize, kColour);
  const Overlay overlay = writer.take();
  ASSERT_EQ(overlay.panels.size(), 1U);
  ASSERT_EQ(overlay.texts.size(), 1U);
  const Overlay::Panel& panel = overlay.panels[0];
  const Overlay::Text& text = overlay.texts[0];
  EXPECT_FLOAT_EQ((panel.low.x + panel.high.x) / 2, 300);
  EXPECT_FLOAT_EQ((panel.low.y + panel.high.y) / 2, 200);
  EXPECT_FLOAT_EQ(text.place.x - panel.low.x, kSize);
  EXPECT_FLOAT_EQ(panel.high.x - (text.place.x + font().width("Text") * kSize), kSize);
  EXPECT_LT(text.place.y, panel.high.y);
  EXPECT_GT(text.place.y - Font::kCapitalHeight * kSize, panel.low.y);
}

TEST(OverlayWriter, APillEnclosesItsLines) {
  OverlayWriter writer(font());
  const float top = writer.pill(std::vector<std::string>{"A long line", "Text"}, {300, 200}, kSize, kColour);
  const Overlay overlay = writer.take();
  ASSERT_EQ(overlay.panels.size(), 1U);
  ASSERT_EQ(overlay.texts.size(), 2U);
  const Overlay::Panel& panel = overlay.panels[0];
  EXPECT_EQ(panel.low.y, top);
  EXPECT_EQ(overlay.texts[0].content, "A long line");
  EXPECT_FLOAT_EQ(overlay.texts[0].place.x - panel.low.x, kSize);
  EXPECT_GT(overlay.texts[0].place.y - Font::kCapitalHeight * kSize, top);
  EXPECT_GT(overlay.texts[1].place.y - overlay.texts[0].place.y, kSize);
  OverlayWriter single(font());
  single.pill("Text", {300, 200}, kSize, kColour);
  const Overlay last = single.take();
  EXPECT_EQ(overlay.texts[1].place, last.texts[0].place) << "the last line does not depend on those above it";
  EXPECT_EQ(panel.high.y, last.panels[0].high.y);
}

}  // namespace
}  // namespace platon::overlay_test
