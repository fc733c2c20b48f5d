#include "server/match/roster.h"

#include <gtest/gtest.h>

#include <map>

#include "protocol/label.h"
#include "protocol/to_client.h"

namespace platon::roster_test {
namespace {

using Names = std::map<std::uint32_t, std::string>;

Names namesIn(const std::vector<SharedBytes>& messages) {
  Names names;
  for (const SharedBytes& message : messages) {
    const Roster roster = std::get<Roster>(*decodeToClient(message));
    for (const RosterEntry& entry : roster.entries) names[entry.slot] = entry.name;
  }
  return names;
}

class PlayerNamesTest : public testing::Test {
 protected:
  // The name that the next player gets.
  std::string claim(std::string_view wanted) { return names_.claim(next_++, wanted); }

  PlayerNames names_{kMaxPlayers};
  std::uint32_t next_ = 0;  // slot
};

TEST_F(PlayerNamesTest, AFreeNameIsGivenAsItIs) {
  EXPECT_EQ(claim("Ann"), "Ann");
  EXPECT_EQ(claim("Łukasz"), "Łukasz");
}

TEST_F(PlayerNamesTest, NamesThatLookAlikeGetANumber) {
  EXPECT_EQ(claim("Ann"), "Ann");
  EXPECT_EQ(claim("Ann"), "Ann 2");
  EXPECT_EQ(claim(" aNN "), "aNN 3");
  EXPECT_EQ(claim("A\u200bnn"), "Ann 4");
  EXPECT_EQ(claim("ANN 2"), "ANN 2 2");
  EXPECT_EQ(claim("ЯНА"), "ЯНА");
  EXPECT_EQ(claim("яна"), "яна 2");
}

TEST_F(PlayerNamesTest, NamesInOtherFormsOfUnicodeGetANumber) {
  EXPECT_EQ(claim("José"), "José");
  EXPECT_EQ(claim("Jose\u0301"), "Jose\u0301 2");
  EXPECT_EQ(claim("Ａｎｎ"), "Ａｎｎ");
  EXPECT_EQ(claim("Ann"), "Ann 2");
  EXPECT_EQ(claim("ﬁx"), "ﬁx");
  EXPECT_EQ(claim("fix"), "fix 2");
  EXPECT_EQ(claim("A\u0301\u0302\u0303\u0304\u0305\u0306\u0307\u0309\u030anna"), "Á\u0302nna");
  EXPECT_EQ(claim("a\u0301\u0302nna"), "a\u0301\u0302nna 2");
}

TEST_F(PlayerNamesTest, ANameWithoutVisibleCharactersIsReplaced) {
  EXPECT_EQ(claim(""), "Player 1");
  EXPECT_EQ(claim("\u200b \u3164\u00a0\u0301"), "Player 2");
  EXPECT_EQ(claim("player 4"), "player 4");
  EXPECT_EQ(claim(""), "Player 4 2");
}

TEST_F(PlayerNamesTest, AReleasedNameIsFree) {
  claim("Ann");
  claim("Ann");
  EXPECT_FALSE(names_.isFree(0));
  names_.release(0);
  EXPECT_TRUE(names_.isFree(0));
  EXPECT_EQ(claim("ann"), "ann");
  EXPECT_EQ(claim("ann"), "ann 3") << "Ann 2 is still there";
}

TEST_F(PlayerNamesTest, TheNumberFitsTheLongestName) {
  const std::string longest(kMaxNameBytes, 'x');
  EXPECT_EQ(claim(longest), longest);
  EXPECT_EQ(claim(longest), longest.substr(0, kMaxNameBytes - 2) + " 2");
  std::string wide;
  while (wide.size() + 3 <= kMaxNameBytes) wide += "世";
  EXPECT_EQ(claim(wide), wide);
  EXPECT_EQ(claim(wide), wide + " 2");
  EXPECT_EQ(claim("a" + wide), "a" + wide);
  EXPECT_EQ(claim("a" + wide), "a" + wide.substr(3) + " 2");
}

TEST_F(PlayerNamesTest, AsManyPlayersAsPossibleCanWantOneName) {
  const std::string longest(kMaxNameBytes, 'x');
  std::string last;
  for (std::uint32_t player = 0; player < kMaxPlayers; ++player) {
    last = claim(longest);
    EXPECT_TRUE(isLabel(last, kMaxNameBytes)) << last;
  }
  EXPECT_EQ(last, longest.substr(0, kMaxNameBytes - 4) + " 256");
}

TEST_F(PlayerNamesTest, TheMessagesHaveAllNamesOrTheChangedOnes) {
  EXPECT_TRUE(names_.all().empty());
  EXPECT_TRUE(names_.takeChanges().empty());
  claim("Ann");
  claim("Ben");
  EXPECT_EQ(namesIn(names_.all()), (Names{{0, "Ann"}, {1, "Ben"}}));
  EXPECT_EQ(namesIn(names_.takeChanges()), (Names{{0, "Ann"}, {1, "Ben"}}));
  names_.release(0);
  EXPECT_EQ(namesIn(names_.all()), (Names{{1, "Ben"}}));
  EXPECT_EQ(namesIn(names_.takeChanges()), (Names{{0, ""}}));
  EXPECT_TRUE(names_.takeChanges().empty());
  EXPECT_EQ(namesIn(names_.all()), (Names{{1, "Ben"}}));
}

TEST_F(PlayerNamesTest, TheMessagesAreEncodedOnceUntilANameChanges) {
  claim("Ann");
  const std::uint8_t* before = names_.all().at(0).data();
  EXPECT_EQ(names_.all().at(0).data(), before);
  claim("Ben");
  EXPECT_EQ(namesIn(names_.all()).size(), 2u);
}

TEST_F(PlayerNamesTest, ManyNamesAreSentInSeveralMessages) {
  for (std::uint32_t slot = 0; slot < kMaxRosterEntries + 1; ++slot) claim("");
  EXPECT_EQ(names_.all().size(), 2u);
  EXPECT_EQ(namesIn(names_.all()).size(), kMaxRosterEntries + 1);
}

TEST_F(PlayerNamesTest, AMutedPlayerIsShownByItsNumber) {
  claim("Ann");
  claim("Ben");
  names_.takeChanges();
  names_.mute(1, true);
  EXPECT_TRUE(names_.isMuted(1));
  EXPECT_EQ(names_.shown(1), "Player 2");
  EXPECT_EQ(namesIn(names_.all()), (Names{{0, "Ann"}, {1, "Player 2"}}));
  EXPECT_EQ(namesIn(names_.takeChanges()), (Names{{1, "Player 2"}}));
  names_.mute(1, false);
  EXPECT_EQ(namesIn(names_.takeChanges()), (Names{{1, "Ben"}}));
  names_.mute(1, false);
  EXPECT_TRUE(names_.takeChanges().empty());
}

TEST_F(PlayerNamesTest, NobodyCanTakeTheNameOrTheNumberOfAMutedPlayer) {
  claim("Ann");
  names_.mute(0, true);
  EXPECT_EQ(claim("Ann"), "Ann 2");
  EXPECT_EQ(claim("player 1"), "player 1 2");
  names_.mute(0, false);
  EXPECT_EQ(claim("player 1"), "player 1");
  names_.mute(0, true);
  EXPECT_EQ(names_.shown(0), "Player 1 3") << "player 1 2 is still there";
}

TEST_F(PlayerNamesTest, AMutedPlayerStaysMutedWhenItGetsAnotherName) {
  claim("");
  names_.mute(0, true);
  EXPECT_EQ(names_.shown(0), "Player 1");
  EXPECT_EQ(names_.rename(0, "Ann"), "Ann");
  EXPECT_EQ(names_.shown(0), "Player 1");
  EXPECT_EQ(names_.rename(0, "Ben"), "Ben");
  EXPECT_EQ(names_.shown(0), "Player 1");
  names_.mute(0, false);
  EXPECT_EQ(names_.shown(0), "Ben");
  EXPECT_EQ(claim("Ann"), "Ann");
}

TEST_F(PlayerNamesTest, AReleasedSlotIsNotMuted) {
  claim("Ann");
  names_.mute(0, true);
  names_.release(0);
  EXPECT_FALSE(names_.isMuted(0));
  EXPECT_EQ(names_.claim(0, "Ben"), "Ben");
  EXPECT_EQ(names_.shown(0), "Ben");
  EXPECT_EQ(names_.claim(1, "Ann"), "Ann");
  EXPECT_EQ(names_.claim(2, "Player 1"), "Player 1");
}

}  // namespace
}  // namespace platon::roster_test
