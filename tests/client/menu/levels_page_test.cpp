#include "client/menu/levels_page.h"

#include <vector>

#include <gtest/gtest.h>

namespace platon {
namespace {

const std::vector<LevelEntry> kLevels{
    {"One", "CUBE", 1, 12.34}, {"Two", "CUBE", 2, {}}, {"Three", "TETRAHEDRON", 2, 5.0}, {"Four", "CUBE"}};

TEST(LevelsPage, EachSolidHasAHeading) {
  const MenuPage page = levelsPage(kLevels, nullptr);
  std::vector<std::string> names;
  for (const MenuItem& item : page.items) names.push_back(item.name);
  EXPECT_EQ(names, (std::vector<std::string>{"CUBE", "One", "Two", "TETRAHEDRON", "Three", "CUBE", "Four"}));
}

TEST(LevelsPage, ShowsPlayersAndBestTimesWhereThereAreSome) {
  const MenuPage page = levelsPage(kLevels, nullptr);
  EXPECT_EQ(page.items[1].value, "★ 12.34 s");
  EXPECT_EQ(page.items[2].value, "2 players");
  EXPECT_EQ(page.items[4].value, "2 players   ★ 5.00 s");
  EXPECT_EQ(page.items[6].value, "");
}

TEST(LevelsPage, ItemsAndLevelsBelongTogether) {
  std::vector<std::size_t> chosen;
  const MenuPage page = levelsPage(kLevels, [&](std::size_t level) { chosen.push_back(level); });
  for (std::size_t level = 0; level < kLevels.size(); ++level) {
    const std::size_t item = itemOfLevel(kLevels, level);
    EXPECT_EQ(page.items[item].name, kLevels[level].title);
    EXPECT_EQ(levelOfItem(kLevels, item), level);
    page.items[item].choose();
  }
  EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(levelOfItem(kLevels, 3), 2U) << "a heading";
  EXPECT_EQ(levelOfItem(kLevels, 99), 3U);
}

}  // namespace
}  // namespace platon
