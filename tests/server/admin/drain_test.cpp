#include "server/admin/drain.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "tests/support/test_levels.h"

namespace platon::drain_test {
namespace {

using namespace std::chrono_literals;

class DrainTest : public testing::Test {
 protected:
  void join(ClientId client) {
    Hello hello;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    match_.receive(client, hello);
  }

  // The texts of the operator that a client was sent since the last call.
  std::vector<std::string> noticesTo(ClientId client) {
    std::vector<std::string> texts;
    for (const Outgoing& sent : match_.takeOutgoing()) {
      const auto message = decodeToClient(sent.bytes);
      const auto* notice = message ? std::get_if<Notice>(&*message) : nullptr;
      if (notice && sent.client == client) texts.push_back(notice->text);
    }
    return texts;
  }

  const TimePoint start_ = TimePoint(100s);
  Match match_{LevelRotation({levelOf(farGoalText()), levelOf(nearGoalText())}), {2, "Test"}};
  Drain drain_{match_};
};

TEST_F(DrainTest, IsNeverOverBeforeItBegins) {
  EXPECT_FALSE(drain_.begun());
  EXPECT_EQ(drain_.over(start_ + 1000h), std::nullopt);
}

TEST_F(DrainTest, IsOverAtOnceWithoutPlayers) {
  drain_.begin(start_, 600s, "");
  EXPECT_TRUE(drain_.begun());
  EXPECT_EQ(drain_.over(start_), "no players");
}

TEST_F(DrainTest, IsOverAtItsLimitAndNotBefore) {
  join(1);
  drain_.begin(start_, 600s, "");
  EXPECT_EQ(drain_.over(start_ + 600s - 1ns), std::nullopt);
  EXPECT_EQ(drain_.over(start_ + 600s), "time");
  EXPECT_EQ(drain_.secondsLeft(start_ + 1ns), 600s);
  EXPECT_EQ(drain_.secondsLeft(start_ + 1s), 599s);
  EXPECT_EQ(drain_.secondsLeft(start_ + 700s), 0s);
  drain_.begin(start_ + 600s, 5s, "");
  EXPECT_EQ(drain_.over(start_ + 604s), std::nullopt) << "another call sets another limit";
}

TEST_F(DrainTest, IsOverAfterThePauseOfTheRound) {
  join(1);
  match_.tick();
  drain_.begin(start_, 600s, "");
  match_.endRoundNow();
  for (std::uint32_t tick = 0; tick < MatchRounds::kPauseTicks; ++tick) {
    EXPECT_EQ(drain_.over(start_), std::nullopt) << tick;
    match_.tick();
  }
  EXPECT_EQ(drain_.over(start_), "round over");
}

TEST_F(DrainTest, PlayersAreToldTheLimitAndTheNextServer) {
  join(1);
  noticesTo(1);
  drain_.begin(start_, 600s, "[2001:db8::1]:7777");
  EXPECT_EQ(noticesTo(1), std::vector<std::string>{"The server stops after this round, in 600 s at most. Go on at "
                                                   "[2001:db8::1]:7777."});
  drain_.begin(start_, 60s, "");
  EXPECT_EQ(noticesTo(1), std::vector<std::string>{"The server stops after this round, in 60 s at most."});
}

TEST_F(DrainTest, TheLongestTextsFitIntoMessages) {
  join(1);
  noticesTo(1);
  drain_.begin(start_, 24h, std::string(kMaxNextServerBytes, 'x'));
  EXPECT_EQ(noticesTo(1).size(), 1u);
  join(2);
  bool refused = false;
  for (const Outgoing& sent : match_.takeOutgoing()) {
    const auto message = decodeToClient(sent.bytes);
    const auto* refusal = message ? std::get_if<Refused>(&*message) : nullptr;
    refused = refused || (refusal && refusal->next == std::string(kMaxNextServerBytes, 'x'));
  }
  EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace platon::drain_test
