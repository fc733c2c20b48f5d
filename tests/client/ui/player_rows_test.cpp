#include "client/ui/player_rows.h"

#include <gtest/gtest.h>

namespace platon::player_rows_test {
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
  EXPECT_EQ(twoDigits(7), "07");
  EXPECT_EQ(twoDigits(10), "10");
  EXPECT_EQ(finishText(0), "0.00 s");
  EXPECT_EQ(finishText(7.05), "7.05 s");
  EXPECT_EQ(finishText(12.345678), "12.35 s");
  EXPECT_EQ(finishText(299.999), "300.00 s");
  EXPECT_EQ(finishTextOf(0), "0.00 s");
  EXPECT_EQ(finishTextOf(12 * kTicksPerSecond + kTicksPerSecond / 4), "12.25 s");
}

TEST(PlayerRows, ARoundTripIsInMillisecondsUpToASecond) {
  PlayerDrawing player = playerOf(0);
  EXPECT_EQ(roundTripText(player), "");
  player.roundTripMs = 0;
  EXPECT_EQ(roundTripText(player), "0 ms");
  player.roundTripMs = 1000;
  EXPECT_EQ(roundTripText(player), "1000 ms");
  player.roundTripMs = 1004;
  EXPECT_EQ(roundTripText(player), "over 1 s");
}

TEST(PlayerRows, OnlyAKnownRoundTripTakesRoom) {
  Scene scene;
  scene.players = {playerOf(1), playerOf(2)};
  EXPECT_EQ(roundTripWidth(scene), 0);
  scene.players[1].roundTripMs = 20;
  EXPECT_GT(roundTripWidth(scene), 0);
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
}  // namespace platon::player_rows_test
