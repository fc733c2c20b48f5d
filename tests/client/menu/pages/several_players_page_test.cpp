#include "client/menu/pages/several_players_page.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::several_players_page_test {
namespace {

TEST(SeveralPlayersPage, SaysWhyInOneSentenceAndOffersWhatCanBeDone) {
  std::string called;
  const MenuPage page =
      severalPlayersPage({.title = "Hold the door", .solid = "CUBE", .players = 2},
                         {[&] { called += "here "; }, [&] { called += "host "; }, [&] { called += "join "; }});
  EXPECT_EQ(page.title, "Hold the door");
  EXPECT_EQ(page.notes,
            std::vector<std::string>{
                "This level needs 2 players: play it together on this machine, host it so that others can join you, or "
                "join somebody who hosts it."});
  ASSERT_EQ(page.items.size(), 3U);
  EXPECT_EQ(page.items[0].name, "Together on this machine");
  EXPECT_EQ(page.items[1].name, "Host it");
  EXPECT_EQ(page.items[2].name, "Join");
  for (const MenuItem& item : page.items) item.choose();
  EXPECT_EQ(called, "here host join ");
}

class HostPage : public testing::Test {
 protected:
  MenuPage page() {
    return hostPage(form_, levels_, [this] { ++hosted_; });
  }

  const std::vector<LevelEntry> levels_{{"One", "CUBE"}, {"Two", "CUBE"}};
  HostForm form_;
  int hosted_ = 0;
};

TEST_F(HostPage, ChoosesALevelRoundTheList) {
  EXPECT_EQ(page().items[0].value, "One");
  page().items[0].step(-1);
  EXPECT_EQ(page().items[0].value, "Two");
  page().items[0].step(1);
  EXPECT_EQ(form_.level, 0U);
}

TEST_F(HostPage, PlaysOnOrTheSameAgain) {
  EXPECT_EQ(page().items[1].value, "the next levels");
  page().items[1].step(1);
  EXPECT_EQ(page().items[1].value, "the same level");
  EXPECT_TRUE(form_.onlyLevel);
  EXPECT_FALSE(page().items[1].repeats()) << "a key that is held would go back and forth";
}

TEST_F(HostPage, TheNumberOfPlayersStaysInItsRange) {
  for (int i = 0; i < 100; ++i) page().items[2].step(-1);
  EXPECT_EQ(page().items[2].value, "1");
  page().items[2].set(1);
  EXPECT_EQ(page().items[2].value, "64");
  page().items[2].step(1);
  EXPECT_EQ(form_.players, 64);
}

TEST_F(HostPage, TheLastItemHosts) {
  EXPECT_EQ(form_.port.text(), "7777");
  EXPECT_EQ(page().items[kHostPortItem].name, "Port");
  EXPECT_EQ(page().items.size(), kHostStartItem + 1);
  page().items.back().choose();
  EXPECT_EQ(hosted_, 1);
  EXPECT_FALSE(page().warning);
  form_.fault = "The port is wrong.";
  EXPECT_TRUE(page().warning);
  EXPECT_EQ(page().notes.front(), form_.fault);
}

class JoinPage : public testing::Test {
 protected:
  MenuPage page() {
    return joinPage(form_, [this] { joined_ = form_.address.text(); });
  }
  bool has(const std::string& name) {
    const MenuPage shown = page();
    return std::any_of(shown.items.begin(), shown.items.end(), [&](const MenuItem& item) { return item.name == name; });
  }

  JoinForm form_;
  std::string joined_;
};

TEST_F(JoinPage, JoinsWhatWasEntered) {
  form_.address.setText("host:1");
  page().items[1].choose();
  EXPECT_EQ(joined_, "host:1");
}

TEST_F(JoinPage, AServerThatWasJoinedBeforeIsOneClickAway) {
  EXPECT_FALSE(has("Joined before"));
  form_.recent = {"one:7777", "two:7777"};
  EXPECT_TRUE(has("Joined before"));
  page().items.back().choose();
  EXPECT_EQ(joined_, "two:7777");
}

TEST_F(JoinPage, AServerNearbyIsOneClickAwayToo) {
  form_.recent = {"one:7777"};
  form_.found = {{"Den", "192.0.2.1:7778", "2/8 players, 3 ms"}};
  EXPECT_TRUE(has("Nearby"));
  EXPECT_EQ(page().items.back().value, "2/8 players, 3 ms");
  page().items.back().choose();
  EXPECT_EQ(joined_, "192.0.2.1:7778");
}

TEST_F(JoinPage, TellsWhyAListIsLeftOut) {
  form_.hasList = true;
  form_.found = {{"Den", "192.0.2.1:7778", "2/8 players, 3 ms"}};
  EXPECT_TRUE(has("Nearby and in the list"));
  EXPECT_EQ(page().notes.size(), 1u);
  form_.listFault = "cannot read the list";
  EXPECT_EQ(page().notes.back(), "cannot read the list");
}

TEST_F(JoinPage, AsksForAListUnlessOneIsGiven) {
  for (const bool asks : {false, true}) {
    form_.asksPassword = asks;
    ASSERT_LT(itemOfList(form_), page().items.size());
    EXPECT_EQ(page().items[itemOfList(form_)].name, "List of servers");
    EXPECT_EQ(page().items[itemOfList(form_)].field, &form_.listUrl);
  }
  form_.asksList = false;
  EXPECT_FALSE(has("List of servers"));
}

TEST_F(JoinPage, AsksForAPasswordOnlyIfTheServerDoes) {
  EXPECT_FALSE(has("Password"));
  form_.asksPassword = true;
  form_.fault = "The password is wrong.";
  EXPECT_TRUE(has("Password"));
  EXPECT_TRUE(page().items[1].secret);
  EXPECT_TRUE(page().warning);
}

}  // namespace
}  // namespace platon::several_players_page_test
