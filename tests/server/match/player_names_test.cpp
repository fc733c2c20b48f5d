#include "server/match/player_names.h"

#include <gtest/gtest.h>

#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

TEST(PlayerNames, AFreeNameIsGivenAsItIs) {
  PlayerNames names;
  EXPECT_EQ(names.claim("Ann", "Player 1"), "Ann");
  EXPECT_EQ(names.claim("Łukasz", "Player 2"), "Łukasz");
}

TEST(PlayerNames, NamesThatLookAlikeGetANumber) {
  PlayerNames names;
  EXPECT_EQ(names.claim("Ann", ""), "Ann");
  EXPECT_EQ(names.claim("Ann", ""), "Ann 2");
  EXPECT_EQ(names.claim(" aNN ", ""), "aNN 3");
  EXPECT_EQ(names.claim("A\u200bnn", ""), "Ann 4");
  EXPECT_EQ(names.claim("ANN 2", ""), "ANN 2 2");
  EXPECT_EQ(names.claim("ЯНА", ""), "ЯНА");
  EXPECT_EQ(names.claim("яна", ""), "яна 2");
}

TEST(PlayerNames, ANameWithoutVisibleCharactersIsReplaced) {
  PlayerNames names;
  EXPECT_EQ(names.claim("", "Player 1"), "Player 1");
  EXPECT_EQ(names.claim("\u200b \u3164\u00a0\u0301", "Player 2"), "Player 2");
  EXPECT_EQ(names.claim("player 3", "Player 7"), "player 3");
  EXPECT_EQ(names.claim("", "Player 3"), "Player 3 2");
}

TEST(PlayerNames, AReleasedNameIsFree) {
  PlayerNames names;
  names.claim("Ann", "");
  names.claim("Ann", "");
  names.release("Ann");
  EXPECT_EQ(names.claim("ann", ""), "ann");
  EXPECT_EQ(names.claim("ann", ""), "ann 3") << "Ann 2 is still there";
}

TEST(PlayerNames, TheNumberFitsTheLongestName) {
  PlayerNames names;
  const std::string longest(kMaxNameBytes, 'x');
  EXPECT_EQ(names.claim(longest, ""), longest);
  EXPECT_EQ(names.claim(longest, ""), longest.substr(0, kMaxNameBytes - 2) + " 2");
  std::string wide;
  while (wide.size() + 3 <= kMaxNameBytes) wide += "世";
  EXPECT_EQ(names.claim(wide, ""), wide);
  EXPECT_EQ(names.claim(wide, ""), wide + " 2");
}

TEST(PlayerNames, AsManyPlayersAsPossibleCanWantOneName) {
  PlayerNames names;
  const std::string longest(kMaxNameBytes, 'x');
  std::string last;
  for (std::uint32_t player = 0; player < kMaxPlayers; ++player) {
    last = names.claim(longest, "");
    EXPECT_TRUE(isLabel(last, kMaxNameBytes)) << last;
  }
  EXPECT_EQ(last, longest.substr(0, kMaxNameBytes - 4) + " 256");
}

}  // namespace
}  // namespace platon
