#include "server/match/updates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "server/match/match.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/test_levels.h"

namespace platon::updates_test {
namespace {

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

ConfirmedTicks collect(const TickHistory& history, std::uint32_t confirmed) {
  ConfirmedTicks message{9, 9, 9, 9, LinkReport{}, {{9, 9, pressing(9)}}};  // as an earlier one may have left it
  history.collect(confirmed, message);
  return message;
}

TEST(TickHistory, StartsWithTheHashOfTheNewGame) {
  const TickHistory history(4, 99);
  EXPECT_EQ(history.end(), 0u);
  EXPECT_TRUE(history.covers(0));
  EXPECT_FALSE(history.covers(1));
  EXPECT_EQ(history.hashAfter(0), 99u);
}

TEST(TickHistory, CollectsOnlyChanges) {
  TickHistory history(4, 99);
  history.append(std::vector<Input>{pressing(1), pressing(0)}, 100);
  history.append(std::vector<Input>{pressing(1), pressing(0)}, 101);
  history.append(std::vector<Input>{pressing(2)}, 102);
  const ConfirmedTicks all{
      4, 0, 3, 102, std::nullopt, {{0, 0, pressing(1)}, {0, 1, pressing(0)}, {2, 0, pressing(2)}, {2, 1, Input{}}}};
  EXPECT_EQ(collect(history, 0), all);
  const ConfirmedTicks last{4, 2, 1, 102, std::nullopt, {{2, 0, pressing(2)}, {2, 1, Input{}}}};
  EXPECT_EQ(collect(history, 2), last);
  EXPECT_EQ(history.hashAfter(1), 100u);
  EXPECT_EQ(history.held(), (std::vector<Input>{pressing(2), Input{}}));
}

TEST(TickHistory, KeepsOnlyTheLastTicks) {
  TickHistory history(1, 0);
  for (std::uint32_t tick = 0; tick < TickHistory::kTicks + 5; ++tick) history.append({}, tick + 1);
  EXPECT_FALSE(history.covers(4));
  ASSERT_TRUE(history.covers(5));
  EXPECT_EQ(history.hashAfter(5), 5u);
  EXPECT_EQ(history.hashAfter(6), 6u);
  EXPECT_EQ(history.hashAfter(history.end()), TickHistory::kTicks + 5u);
  EXPECT_EQ(collect(history, 5).count, kMaxTicksPerMessage);
}

// Checked on random inputs. Every message must also be within its limit.
TEST(TickHistory, ConsecutiveMessagesContainEveryInput) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  TickHistory history(1, 0);
  std::vector<std::vector<Input>> decided;
  for (std::uint32_t tick = 0; tick < 300; ++tick) {
    std::vector<Input> inputs(random() % (kMaxPlayers + 1));
    for (Input& input : inputs) input = random() % 3 == 0 ? Input{} : pressing(static_cast<int>(random() % 32));
    history.append(inputs, tick);
    inputs.resize(kMaxPlayers);
    decided.push_back(inputs);
  }
  std::vector<Input> held(kMaxPlayers);
  for (std::uint32_t tick = 0; tick < history.end();) {
    const ConfirmedTicks message = collect(history, tick);
    ASSERT_GE(message.count, 1u);
    ASSERT_LE(encode(message).size(), kMaxMessageBytes);
    auto change = message.changes.begin();
    for (const std::uint32_t end = tick + message.count; tick < end; ++tick) {
      for (; change != message.changes.end() && change->tick == tick; ++change) held[change->slot] = change->input;
      ASSERT_EQ(held, decided[tick]) << "tick " << tick;
    }
    ASSERT_EQ(message.hash, history.hashAfter(tick));
  }
}

class TickDeliveryTest : public testing::Test {
 protected:
  TickDelivery delivery_;
};

// One message in four starts at the first unacknowledged tick, the others eight ticks before the end.
TEST_F(TickDeliveryTest, EveryFourthMessageRepeatsAllUnacknowledgedTicks) {
  delivery_.acknowledge(100);
  std::vector<std::uint32_t> starts;
  for (int message = 0; message < 5; ++message) {
    starts.push_back(delivery_.nextToSend(140, 1));
    delivery_.sent(starts.back(), 140, 140);
  }
  EXPECT_EQ(starts, (std::vector<std::uint32_t>{100, 132, 132, 132, 100}));
  delivery_.acknowledge(135);
  EXPECT_EQ(delivery_.nextToSend(140, 1), 135u);
  EXPECT_EQ(delivery_.nextToSend(3, 1), 135u);
}

// The rarer the messages, the more ticks each repeats: a tick is in four messages at least.
TEST_F(TickDeliveryTest, RareMessagesRepeatMoreTicks) {
  delivery_.acknowledge(100);
  delivery_.sent(100, 140, 140);
  EXPECT_EQ(delivery_.nextToSend(140, 1), 132u);
  EXPECT_EQ(delivery_.nextToSend(140, 2), 132u);
  EXPECT_EQ(delivery_.nextToSend(140, 3), 128u);
}

TEST_F(TickDeliveryTest, AMessageContinuesWhereTheLastOneWasFull) {
  delivery_.acknowledge(100);
  delivery_.sent(100, 340, 500);
  EXPECT_EQ(delivery_.nextToSend(500, 1), 340u);
  delivery_.sent(340, 500, 500);
  EXPECT_EQ(delivery_.nextToSend(500, 1), 492u);
}

// Whatever the number of messages in between.
TEST_F(TickDeliveryTest, AllUnacknowledgedTicksAreRepeatedAfterMessagesInParts) {
  for (std::uint32_t parts = 3; parts < 8; ++parts) {
    delivery_.acknowledge(100 * parts);
    delivery_.sent(100 * parts, 100 * parts + 1, 100 * parts + 50);
    for (std::uint32_t i = 1; i < parts; ++i) delivery_.sent(100 * parts + i, 100 * parts + i + 1, 100 * parts + 50);
    delivery_.sent(100 * parts + parts, 100 * parts + 50, 100 * parts + 50);
    EXPECT_EQ(delivery_.nextToSend(100 * parts + 50, 3), 100 * parts) << parts << " parts";
  }
}

TEST_F(TickDeliveryTest, FallsBehindWhenMessagesHoldFewTicks) {
  delivery_.sent(100, 105, 200);
  EXPECT_FALSE(delivery_.fallsBehind(2));
  EXPECT_TRUE(delivery_.fallsBehind(3));
  delivery_.sent(105, 200, 200);
  EXPECT_FALSE(delivery_.fallsBehind(3));
  delivery_.sent(195, 200, 200);
  EXPECT_FALSE(delivery_.fallsBehind(3)) << "it held all";
}

// The client acknowledges the first part before the second is sent.
TEST_F(TickDeliveryTest, AMessageContinuesWhereAnAcknowledgedOneWasFull) {
  delivery_.acknowledge(100);
  delivery_.sent(100, 102, 150);
  delivery_.acknowledge(102);
  EXPECT_EQ(delivery_.nextToSend(150, 3), 102u);
}

// 128 clients join within half a second, four in each tick.
TEST(MatchNames, ChangedNamesAreSentAtMostFourTimesASecond) {
  Match match(LevelRotation({levelOf(farGoalText())}), {kMaxPlayers, "Test"});
  std::map<ClientId, std::map<std::uint32_t, std::string>> names;
  std::map<ClientId, std::set<std::uint32_t>> ticksWithNames;
  for (std::uint32_t tick = 0; tick < 4 * MatchUpdates::kNamesTicks; ++tick) {
    for (ClientId i = 1; i <= 4 && tick < 32; ++i) match.receive(4 * tick + i, Hello{});
    match.tick();
    for (const Outgoing& message : match.takeOutgoing()) {
      const auto decoded = decodeToClient(message.bytes);
      const Roster* roster = std::get_if<Roster>(&*decoded);
      if (!roster) continue;
      ticksWithNames[message.client].insert(tick);
      for (const RosterEntry& entry : roster->entries) names[message.client][entry.slot] = entry.name;
    }
  }
  EXPECT_EQ(names.size(), 128u);
  for (const auto& [client, known] : names) EXPECT_EQ(known.size(), 128u) << client;
  EXPECT_EQ(ticksWithNames[1].size(), 4u);
  EXPECT_LE(ticksWithNames[128].size(), 2u);
}

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

/// A match without a network: messages of clients take effect at once. Client N has slot N - 1 and a round trip of
/// 20 N ms.
class MatchRoundTrips : public testing::Test {
 protected:
  explicit MatchRoundTrips(MatchProgram program = {.roundTrip = twentyTimes})
      : match_(LevelRotation({levelOf(farGoalText())}), {}, std::move(program)) {}

  static std::uint32_t twentyTimes(ClientId client) { return 20 * client; }
  void join(ClientId first, ClientId last) {
    for (ClientId client = first; client <= last; ++client) {
      Hello hello;
      hello.token = SessionToken{static_cast<std::uint8_t>(client)};
      match_.receive(client, hello);
    }
  }
  // The messages of the next ticks by client.
  std::map<ClientId, std::vector<RoundTrips>> sentIn(std::uint64_t ticks) {
    std::map<ClientId, std::vector<RoundTrips>> found;
    for (; ticks > 0; --ticks) {
      match_.tick();
      for (const Outgoing& sent : match_.takeOutgoing()) {
        const auto message = decodeToClient(sent.bytes);
        const auto* trips = message ? std::get_if<RoundTrips>(&*message) : nullptr;
        if (trips == nullptr) continue;
        EXPECT_FALSE(sent.reliable || sent.last);
        found[sent.client].push_back(*trips);
      }
    }
    return found;
  }

  Match match_;
};

TEST_F(MatchRoundTrips, EveryPlayerIsToldThoseOfAllOnceInTwoSeconds) {
  join(1, 3);
  const RoundTrips expected{{codeOfRoundTrip(20), codeOfRoundTrip(40), codeOfRoundTrip(60)}};
  const auto sent = sentIn(10 * kTicksPerSecond);
  ASSERT_EQ(sent.size(), 3u);
  for (const auto& [client, messages] : sent) EXPECT_EQ(messages, std::vector<RoundTrips>(5, expected)) << client;
}

TEST_F(MatchRoundTrips, APlayerWhoIsAloneIsToldNone) {
  join(1, 1);
  EXPECT_TRUE(sentIn(10 * kTicksPerSecond).empty());
}

class UnknownRoundTrips : public MatchRoundTrips {
 protected:
  UnknownRoundTrips() : MatchRoundTrips(MatchProgram{}) {}
};

TEST_F(UnknownRoundTrips, AMatchThatDoesNotKnowThemTellsNone) {
  join(1, 3);
  EXPECT_TRUE(sentIn(10 * kTicksPerSecond).empty());
}

TEST_F(MatchRoundTrips, APlayerWhoHasLeftOrIsDisconnectedHasNone) {
  join(1, 5);
  match_.tick();
  match_.remove(1);
  match_.disconnect(3);
  match_.disconnect(5);
  const auto sent = sentIn(MatchUpdates::kRoundTripsTicks);
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent.at(2), (std::vector<RoundTrips>{{{0, codeOfRoundTrip(40), 0, codeOfRoundTrip(80)}}}));
}

/// The largest match: a message still fits into a datagram, together with all that ENet and the seal add.
TEST_F(MatchRoundTrips, AMessageOfTheLargestMatchIsShort) {
  const RoundTrips all{std::vector<std::uint8_t>(kMaxPlayers, UINT8_MAX)};
  EXPECT_LE(encode(all).size(), 320u);
  const RoundTrips sixteen{std::vector<std::uint8_t>(16, UINT8_MAX)};
  EXPECT_LE(encode(sixteen).size(), 80u);
}

}  // namespace
}  // namespace platon::updates_test
