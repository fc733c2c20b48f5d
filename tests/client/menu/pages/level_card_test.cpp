#include "client/menu/pages/level_card.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/menu/menu_layout.h"
#include "client/menu/pages/turntable.h"
#include "client/ui/text_scale.h"

namespace platon::level_card_test {
namespace {

std::vector<std::string> textsOf(const LevelEntry& level, float width, float scale = 1) {
  const Font font;
  Overlay overlay;
  addLevelCard(overlay, level, font, width, scale);
  std::vector<std::string> texts;
  for (const Overlay::Text& text : overlay.texts) {
    texts.push_back(text.content);
    EXPECT_GT(text.place.x, width / 2);
    EXPECT_LT(text.place.x + font.width(text.content) * text.size, width);
    EXPECT_LT(text.place.y, Overlay::kHeight);
  }
  return texts;
}

bool overlap(const MenuBox& a, const MenuBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

TEST(LevelCard, ShowsTitlePlayersAndMedals) {
  LevelEntry level{"Half turn", "Tetrahedron · fire", 2};
  EXPECT_EQ(textsOf(level, 1280), (std::vector<std::string>{"Half turn", "Tetrahedron · fire · 2 players"}));
  level.players = 1;
  level.medals = medalTimesOf(600);
  EXPECT_EQ(textsOf(level, 1280), (std::vector<std::string>{"Half turn", "Tetrahedron · fire · 1 player", "★★★ 11.50 s",
                                                            "★★☆ 15.00 s", "★☆☆ 25.00 s"}));
}

TEST(LevelCard, StaysBesideTheMenuWithLongTexts) {
  const Font font;
  const LevelEntry level{std::string(100, 'W'), "Icosahedron · water", 64, {}, medalTimesOf(2'000'000)};
  for (const float scale : {0.75F, 1.0F, textScale(1, 360), 1.5F, 1.75F}) {
    for (float width = 960; width < 1800; width += 40) {
      SCOPED_TRACE(testing::Message() << width << " at " << scale);
      Overlay card;
      addLevelCard(card, level, font, width, scale);
      const float menu = scale * endOfLeftColumn(glm::vec2(width, Overlay::kHeight) / scale);
      std::vector<MenuBox> boxes;
      for (const Overlay::Text& text : card.texts) {
        const glm::vec2 end = text.place + glm::vec2(font.width(text.content) * text.size, 0.3F * text.size);
        boxes.push_back({text.place - glm::vec2(0, text.size), end});
      }
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_GE(boxes[i].low.x, menu) << card.texts[i].content;
        EXPECT_LE(boxes[i].high.x, width) << card.texts[i].content;
        EXPECT_LE(boxes[i].high.y, Overlay::kHeight);
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << card.texts[i].content;
      }
      for (const Overlay::Panel& panel : card.panels) {
        EXPECT_GE(panel.low.x, menu);
        EXPECT_LE(panel.high.x, width);
        EXPECT_LE(panel.high.y, Overlay::kHeight);
      }
    }
  }
}

TEST(LevelCard, LeavesOutWhatHasNoRoomBesideTheMenu) {
  const LevelEntry level{"Half turn", "Tetrahedron · fire", 1, {}, medalTimesOf(600)};
  EXPECT_EQ(textsOf(level, 1280, 1.5F).size(), 2U);
  EXPECT_TRUE(textsOf(level, 1280, 2).empty());
}

TEST(LevelCard, IsLeftOutWhereThereIsNoRoomBesideTheMenu) {
  EXPECT_TRUE(textsOf({"Half turn", "Tetrahedron · fire"}, Turntable::kWide * Overlay::kHeight).empty());
}

}  // namespace
}  // namespace platon::level_card_test
