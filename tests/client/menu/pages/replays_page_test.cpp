#include "client/menu/pages/replays_page.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/menu/pages/levels_page.h"

namespace platon::replays_page_test {
namespace {

const std::vector<ReplayEntry> kEntries{
    {"One", "1.00 s", "2026-01-02", "", true},
    {"Two", "2.00 s", "2026-01-01", "", false, "is a damaged recording: byte 5: wrong"},
    {"One", "1.50 s", "2026-01-03", "Anna"},
    {"Three", "", "2026-01-02", "round"}};

TEST(ReplaysPage, OwnRunsAndThoseOfOthersHaveHeadings) {
  const MenuPage page = replaysPage(kEntries, nullptr, nullptr);
  std::vector<std::string> names;
  for (const MenuItem& item : page.items) names.push_back(item.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Your best runs", "One", "Two", "Runs of others", "One", "Three"}));
  EXPECT_TRUE(page.notes.empty());
}

TEST(ReplaysPage, ARowShowsWhoTimeAndDate) {
  const MenuPage page = replaysPage(kEntries, nullptr, nullptr);
  EXPECT_EQ(page.items[1].value, "★ 1.00 s · 2026-01-02");
  EXPECT_EQ(page.items[2].value, "2.00 s · is a damaged recording · 2026-01-01");
  EXPECT_EQ(page.items[4].value, "Anna · 1.50 s · 2026-01-03");
  EXPECT_EQ(page.items[5].value, "round · 2026-01-02");
}

// Before, the best run had a star here and none in the list of levels.
TEST(ReplaysPage, ARunHasTheMedalThatItHasInTheListOfLevels) {
  const MedalTimes medals = medalTimesOf(60);
  const LevelEntry level{.title = "One", .solid = "CUBE", .bestTicks = 600, .medals = medals};
  ReplayEntry best{"One", "10.00 s", "2026-01-02", "", true};
  best.medal = medalFor(medals, 600);
  ReplayEntry friends{"One", "1.00 s", "2026-01-02", "Anna"};
  friends.medal = medalFor(medals, 60);
  const std::vector<ReplayEntry> entries{best, friends};
  const MenuPage page = replaysPage(entries, nullptr, nullptr);
  const MenuItem inLevels = levelsPage({&level, 1}, nullptr).items[1];
  EXPECT_EQ(inLevels.value, "☆☆☆ 10.00 s");
  EXPECT_EQ(page.items[1].value, inLevels.value + " · 2026-01-02");
  EXPECT_EQ(page.items[1].valueColour, inLevels.valueColour);
  EXPECT_EQ(page.items[3].value, "Anna · ★★★ 1.00 s · 2026-01-02");
  EXPECT_EQ(page.items[3].valueColour, colourOf(Medal::kGold));
}

TEST(ReplaysPage, ItemsAndEntriesBelongTogether) {
  std::vector<std::size_t> chosen;
  const MenuPage page = replaysPage(
      kEntries, [&](std::size_t entry) { chosen.push_back(entry); }, nullptr);
  for (std::size_t entry = 0; entry < kEntries.size(); ++entry) {
    const std::size_t item = itemOfReplay(kEntries, entry);
    EXPECT_EQ(page.items[item].name, kEntries[entry].title);
    EXPECT_EQ(replayOfItem(kEntries, item), entry);
    page.items[item].choose();
  }
  EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(replayOfItem(kEntries, 3), 2U) << "a heading";
  EXPECT_EQ(replayOfItem(kEntries, 99), 3U);
}

TEST(ReplaysPage, AnEmptyListSaysHowRunsGetThere) {
  bool left = false;
  const MenuPage page = replaysPage({}, nullptr, [&] { left = true; });
  ASSERT_EQ(page.notes.size(), 1U);
  EXPECT_NE(page.notes[0].find("Reach a goal"), std::string::npos);
  ASSERT_EQ(page.items.size(), 1U);
  page.items[0].choose();
  EXPECT_TRUE(left);
}

std::vector<std::string> namesOf(const MenuPage& page) {
  std::vector<std::string> names;
  for (const MenuItem& item : page.items) names.push_back(item.name);
  return names;
}

TEST(RunPage, OffersWhatIsSet) {
  std::string called;
  RunChoices choices;
  choices.watch = [&] { called += "watch "; };
  choices.back = [&] { called += "back "; };
  EXPECT_EQ(namesOf(runPage({"One"}, "file", "", choices)), std::vector<std::string>{"Watch"});
  choices.race = [&] { called += "race "; };
  choices.keep = [&] { called += "keep "; };
  const MenuPage page = runPage({"One"}, "file", "", choices);
  for (const MenuItem& item : page.items) item.choose();
  EXPECT_EQ(called, "watch race keep ");
}

// Before, each had an item for it, where the pages around it have the mark.
TEST(RunPage, HasAnItemThatLeadsBackOnlyIfItHasNoOther) {
  RunChoices choices;
  choices.back = [] {};
  const MenuPage damaged = runPage({"One"}, "file", "", choices);
  EXPECT_EQ(namesOf(damaged), std::vector<std::string>{"Back"});
  EXPECT_FALSE(damaged.backMark);
  choices.watch = [] {};
  EXPECT_TRUE(runPage({"One"}, "file", "", choices).backMark);
}

TEST(RunPage, NamesTheFileAndSaysWhoseItIs) {
  const MenuPage own = runPage({"One", "1.00 s", "2026-01-02", "", true}, "~/runs/x", "", {});
  EXPECT_EQ(own.title, "One");
  EXPECT_EQ(own.notes[0], "Your run: ★ 1.00 s, your best. 2026-01-02");
  EXPECT_NE(own.notes[1].find("send this file"), std::string::npos);
  EXPECT_EQ(own.notes[2], "~/runs/x");
  EXPECT_FALSE(own.warning);
  ReplayEntry rated{"One", "1.00 s", "2026-01-02", "Anna"};
  rated.medal = Medal::kSilver;
  EXPECT_EQ(runPage(rated, "x", "", {}).notes[0], "A recording of Anna: ★★☆ 1.00 s. 2026-01-02");
  const MenuPage other = runPage({"One", "", "2026-01-02", "Anna"}, "x", "", {});
  EXPECT_EQ(other.notes[0], "A recording of Anna. 2026-01-02");
}

TEST(RunPage, SaysWhyItCannotBePlayedOrKept) {
  const MenuPage damaged = runPage({"One", "", "", "", false, "is a damaged recording"}, "x", "", {});
  EXPECT_EQ(damaged.notes[1], "It is a damaged recording.");
  EXPECT_TRUE(damaged.warning);
  const MenuPage noRun = runPage({"One", "", "", "", false, "", "is no run: it ends elsewhere"}, "x", "", {});
  EXPECT_EQ(noRun.notes[1], "It is no run: it ends elsewhere.");
  EXPECT_FALSE(noRun.warning) << "it can be watched";
  const MenuPage full = runPage({"One"}, "x", "It cannot be kept: the disk is full.", {});
  EXPECT_EQ(full.notes[1], "It cannot be kept: the disk is full.");
  EXPECT_TRUE(full.warning);
}

}  // namespace
}  // namespace platon::replays_page_test
