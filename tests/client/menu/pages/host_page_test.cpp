#include "client/menu/pages/host_page.h"

#include <vector>

#include <gtest/gtest.h>

namespace platon::host_page_test {
namespace {

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

}  // namespace
}  // namespace platon::host_page_test
