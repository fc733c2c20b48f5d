#include "client/menu/pages/several_players_page.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::several_players_page_test {
namespace {

TEST(SeveralPlayersPage, SaysWhyInOneSentenceAndOffersWhatCanBeDone) {
  std::string called;
  const MenuPage page = severalPlayersPage({.title = "Hold the door", .solid = "CUBE", .players = 2},
                                           {[&] { called += "host "; }, [&] { called += "join "; }});
  EXPECT_EQ(page.title, "Hold the door");
  EXPECT_EQ(page.notes,
            std::vector<std::string>{
                "This level needs 2 players: host it so that others can join you, or join somebody who hosts it."});
  ASSERT_EQ(page.items.size(), 2U);
  EXPECT_EQ(page.items[0].name, "Host it");
  EXPECT_EQ(page.items[1].name, "Join");
  for (const MenuItem& item : page.items) item.choose();
  EXPECT_EQ(called, "host join ");
}

}  // namespace
}  // namespace platon::several_players_page_test
