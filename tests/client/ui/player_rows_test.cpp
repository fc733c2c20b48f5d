#include "client/ui/player_rows.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

PlayerDrawing playerOf(std::uint32_t slot, std::optional<double> finishSeconds = {}) {
  PlayerDrawing player;
  player.slot = slot;
  player.number = std::to_string(slot + 1);
  player.finishSeconds = finishSeconds;
  return player;
}

TEST(PlayerRows, TheFastestComesFirstAndThoseWhoHaveNotFinishedComeLastBySlot) {
  Scene scene;
  scene.players = {playerOf(4), playerOf(1, 9.5), playerOf(2), playerOf(3, 7), playerOf(5, 9.5)};
  std::string order;
  for (const PlayerDrawing* player : inOrder(scene)) order += player->number;
  EXPECT_EQ(order, "42635");
}

TEST(PlayerRows, TimesHaveHundredths) {
  EXPECT_EQ(finishText(0), "0.00 s");
  EXPECT_EQ(finishText(7.05), "7.05 s");
  EXPECT_EQ(finishText(12.345678), "12.35 s");
  EXPECT_EQ(finishText(299.999), "300.00 s");
}

TEST(PlayerRows, WhoHasNoNameIsCalledByItsNumber) {
  EXPECT_EQ(calledName("", "7"), "Player 7");
  EXPECT_EQ(calledName("Ann", "7"), "Ann");
}

TEST(PlayerRows, ALongNameIsCutBetweenCodePointsAndNoNameIsTheNumber) {
  PlayerDrawing player = playerOf(6);
  EXPECT_EQ(shownNameOf(player), "Player 7");
  player.name = "Ann";
  EXPECT_EQ(shownNameOf(player), "Ann");
  std::string cut;
  for (int i = 0; i < 20; ++i) cut += "ж";
  player.name = cut + "ж";
  EXPECT_EQ(shownNameOf(player), cut + "…");
  player.name = cut;
  EXPECT_EQ(shownNameOf(player), cut);
}

}  // namespace
}  // namespace platon
