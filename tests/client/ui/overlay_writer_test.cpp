#include "client/ui/overlay_writer.h"

#include <gtest/gtest.h>

namespace platon::overlay_writer_test {
namespace {

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
}  // namespace platon::overlay_writer_test
