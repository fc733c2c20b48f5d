#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <string>

#include "server/match/match.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/test_levels.h"

namespace platon::match_rate_test {
namespace {

constexpr int kTicks = 60;

Match matchOf(std::uint32_t players) {
  Match match(LevelRotation({levelOf(farGoalText())}), {kMaxPlayers, "Test"});
  for (ClientId client = 1; client <= players; ++client) match.receive(client, Hello{});
  return match;
}

// Numbers of messages of ticks that each of so many players is sent.
std::map<ClientId, int> messagesIn(int ticks, std::uint32_t players) {
  Match match = matchOf(players);
  std::map<ClientId, int> messages;
  for (int tick = 0; tick < ticks; ++tick) {
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) messages[message.client] += message.reliable ? 0 : 1;
  }
  return messages;
}

class MatchRateTest : public testing::TestWithParam<std::pair<std::uint32_t, int>> {};

TEST_P(MatchRateTest, TheMorePlayersTheRarerTheMessages) {
  const auto [players, interval] = GetParam();
  const std::map<ClientId, int> messages = messagesIn(kTicks, players);
  ASSERT_EQ(messages.size(), players);
  for (const auto& [client, count] : messages) EXPECT_EQ(count, kTicks / interval) << "client " << client;
}

INSTANTIATE_TEST_SUITE_P(Players, MatchRateTest,
                         testing::Values(std::pair(1u, 1), std::pair(4u, 1), std::pair(5u, 2), std::pair(32u, 2),
                                         std::pair(33u, 3), std::pair(kMaxPlayers, 3)));

struct Progress {
  std::uint32_t confirmed = 0;
  std::uint32_t hash = 0;
};

// A match in which all players change their buttons in every tick: a message holds the changes of two ticks. One client
// acknowledges what it gets, so many ticks later; the others acknowledge all ticks at once.
class TogglingMatch {
 public:
  TogglingMatch(ClientId measured, std::size_t delay)
      : measured_(measured), delay_(delay), progress_{0, shortHash(match_.game().hash())} {}

  // `lost`: whether a message to the measured client is lost. Returns how many ticks the client is behind.
  std::uint32_t tick(bool lost) {
    sendInputs();
    match_.tick();
    ++end_;
    for (const Outgoing& message : match_.takeOutgoing()) {
      if (message.client == measured_ && !message.reliable && !lost) receive(message);
    }
    return end_ - progress_.confirmed;
  }

 private:
  void sendInputs() {
    const Input input{static_cast<std::uint8_t>((end_ % 2 == 0 ? Input::kLeft : 0) | Input::kPresent)};
    inTransit_.push_back(progress_);
    const Progress late = inTransit_.front();
    if (inTransit_.size() > delay_) inTransit_.pop_front();
    const Progress all{end_, shortHash(match_.game().hash())};
    for (ClientId client = 1; client <= kMaxPlayers; ++client) {
      const Progress& known = client == measured_ ? late : all;
      match_.receive(client, PlayerInputs{1, 0, known.confirmed, known.hash, end_, {input}, 0});
    }
  }

  void receive(const Outgoing& message) {
    const auto decoded = decodeToClient(message.bytes);
    ASSERT_TRUE(decoded);
    const auto& ticks = std::get<ConfirmedTicks>(*decoded);
    const std::uint32_t end = ticks.from + ticks.count;
    if (ticks.from <= progress_.confirmed && progress_.confirmed < end) progress_ = {end, ticks.hash};
  }

  Match match_ = matchOf(kMaxPlayers);
  ClientId measured_;
  std::size_t delay_;
  Progress progress_;
  std::deque<Progress> inTransit_;
  std::uint32_t end_ = 0;
};

// Largest number of ticks that the client is behind in the third second. `lost` messages are lost one after another.
std::uint32_t mostBehind(std::size_t delay, int lostFrom, int lost) {
  TogglingMatch match(1, delay);
  std::uint32_t most = 0;
  for (int tick = 0; tick < 3 * kTicks; ++tick) {
    const std::uint32_t behind = match.tick(tick >= lostFrom && tick < lostFrom + lost);
    if (tick >= 2 * kTicks) most = std::max(most, behind);
  }
  return most;
}

class TogglingMatchTest : public testing::TestWithParam<std::size_t> {};

TEST_P(TogglingMatchTest, AClientKeepsUpWithPlayersWhoChangeTheirButtonsInEveryTick) {
  EXPECT_LE(mostBehind(GetParam(), 0, 0), GetParam() + 2);
}

// Whichever messages they are: a rest of the ticks, or one that begins with the first unacknowledged tick.
TEST_P(TogglingMatchTest, AClientCatchesUpAfterLostMessages) {
  for (int from = 30; from < 30 + (hasSanitizers() ? 1 : 8); ++from) {
    for (const int lost : {1, 10}) {
      EXPECT_LE(mostBehind(GetParam(), from, lost), GetParam() + 2) << lost << " messages from tick " << from;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Delays, TogglingMatchTest, testing::Values(0, 15));

}  // namespace
}  // namespace platon::match_rate_test
