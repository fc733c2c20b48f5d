#include "client/menu/pages/join_page.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace platon::join_page_test {
namespace {

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
}  // namespace platon::join_page_test
