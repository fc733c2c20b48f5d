#include "client/menu/pages/levels_page.h"

#include <vector>

#include <gtest/gtest.h>

namespace platon::levels_page_test {
namespace {

const std::vector<LevelEntry> kLevels{
    {"One", "CUBE", 1, 741}, {"Two", "CUBE", 2, {}}, {"Three", "TETRAHEDRON", 2, 300}, {"Four", "CUBE"}};

TEST(LevelsPage, EachSolidHasAHeadingAndLevelsForSeveralPlayersStandBelow) {
  const MenuPage page = levelsPage(kLevels, nullptr);
  std::vector<std::string> names;
  for (const MenuItem& item : page.items) names.push_back(item.name);
  EXPECT_EQ(names, (std::vector<std::string>{"CUBE", "One", "Four", "For 2 players", "Two", "Three"}));
}

TEST(LevelsPage, ShowsBestTimesWhereThereAreSomeAndTheSolidBelow) {
  const MenuPage page = levelsPage(kLevels, nullptr);
  EXPECT_EQ(page.items[1].value, "★ 12.35 s");
  EXPECT_EQ(page.items[2].value, "");
  EXPECT_EQ(page.items[4].value, "CUBE");
  EXPECT_EQ(page.items[5].value, "TETRAHEDRON · ★ 5.00 s");
}

TEST(LevelsPage, AMedalHasItsStarsAndItsColour) {
  const std::vector<LevelEntry> levels{{"One", "CUBE", 1, 900, medalTimesOf(600)},
                                       {"Two", "CUBE", 1, 9000, medalTimesOf(600)},
                                       {"Three", "CUBE", 1, {}, medalTimesOf(600)}};
  const MenuPage page = levelsPage(levels, nullptr);
  EXPECT_EQ(page.items[1].value, "★★☆ 15.00 s");
  EXPECT_EQ(page.items[1].valueColour, colourOf(Medal::kSilver));
  EXPECT_EQ(page.items[2].value, "☆☆☆ 150.00 s");
  EXPECT_EQ(page.items[2].valueColour, colourOf(Medal::kNone));
  EXPECT_EQ(page.items[3].value, "");
}

TEST(LevelsPage, AGoalThatWasReachedWithoutATimeHasACheckMark) {
  const std::vector<LevelEntry> levels{{.title = "One", .solid = "CUBE", .reached = true},
                                       {.title = "Two", .solid = "CUBE", .bestTicks = 60, .reached = true}};
  const MenuPage page = levelsPage(levels, nullptr);
  EXPECT_EQ(page.items[1].value, "✓");
  EXPECT_EQ(page.items[2].value, "★ 1.00 s");
}

TEST(LevelsPage, ATimeOfOlderRulesSaysSoAndGivesNoMedal) {
  LevelEntry level{.title = "One", .solid = "CUBE", .medals = medalTimesOf(600), .olderTicks = 741};
  const auto valueOf = [](const LevelEntry& entry) { return levelsPage({&entry, 1}, nullptr).items[1].value; };
  EXPECT_EQ(valueOf(level), "12.35 s, older rules");
  EXPECT_FALSE(levelsPage({&level, 1}, nullptr).items[1].valueColour);
  level.reached = true;
  EXPECT_EQ(valueOf(level), "✓ 12.35 s, older rules");
  level.players = 2;
  EXPECT_EQ(valueOf(level), "CUBE · ✓ 12.35 s, older rules");
  level.bestTicks = 900;
  EXPECT_EQ(valueOf(level), "CUBE · ★★☆ 15.00 s");
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
  EXPECT_EQ(levelOfItem(kLevels, 3), 1U) << "a heading";
  EXPECT_EQ(levelOfItem(kLevels, 99), 2U) << "the last row";
}

}  // namespace
}  // namespace platon::levels_page_test
