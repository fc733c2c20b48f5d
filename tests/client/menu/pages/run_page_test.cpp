#include "client/menu/pages/run_page.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::run_page_test {
namespace {

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
}  // namespace platon::run_page_test
