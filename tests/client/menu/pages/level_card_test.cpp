#include "client/menu/pages/level_card.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/menu/pages/turntable.h"

namespace platon {
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

TEST(LevelCard, ShowsTitlePlayersAndMedals) {
  LevelEntry level{"Half turn", "Tetrahedron · fire", 2};
  EXPECT_EQ(textsOf(level, 1280), (std::vector<std::string>{"Half turn", "Tetrahedron · fire · 2 players"}));
  level.players = 1;
  level.medals = medalTimesOf(600);
  EXPECT_EQ(textsOf(level, 1280), (std::vector<std::string>{"Half turn", "Tetrahedron · fire · 1 player", "★★★ 11.50 s",
                                                            "★★☆ 15.00 s", "★☆☆ 25.00 s"}));
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
}  // namespace platon
