#include "protocol/to_client.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <variant>

#include "tests/protocol/sample_messages.h"

namespace platon::to_client_test {
namespace {

TEST(ToClient, DecodesWhatWasEncoded) {
  const std::vector<ToClient> samples = sampleToClient();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(decodeToClient(encodeAny(samples[i])), samples[i]) << "sample " << i;
  }
}

TEST(ToClient, EveryKindOfMessageHasASample) {
  std::set<std::size_t> kinds;
  for (const ToClient& sample : sampleToClient()) kinds.insert(sample.index());
  EXPECT_EQ(kinds.size(), std::variant_size_v<ToClient>);
}

TEST(ToClient, DecodesBytesAtAnyAddress) {
  for (const ToClient& sample : sampleToClient()) {
    std::vector<std::uint8_t> shifted = encodeAny(sample);
    shifted.insert(shifted.begin(), 0);
    EXPECT_EQ(decodeToClient(std::span(shifted).subspan(1)), sample);
  }
}

TEST(ToClient, TheLongestTickMessageIsWithinItsLimit) {
  ConfirmedTicks message{
      UINT32_MAX, 0x7fffffff, kMaxTicksPerMessage, 1, LinkReport{255, 100, SlackReport{0, -kMaxSlack}}, {}};
  // As many gaps of three ticks as possible, then all other changes in the last tick.
  std::uint32_t slot = 0;
  for (std::uint32_t gap = 1; gap < kMaxTicksPerMessage / 3; ++gap) {
    message.changes.push_back({message.from + 3 * gap, slot = 0, pressing(31)});
  }
  while (message.changes.size() < kMaxChangesPerMessage) {
    message.changes.push_back({message.changes.back().tick, slot = (slot + 1) % 256, pressing(31)});
  }
  EXPECT_GT(encode(message).size(), kMaxMessageBytes * 9 / 10);
  EXPECT_LE(encode(message).size(), kMaxMessageBytes);
}

TEST(ToClient, AChangeTakesTwoBytes) {
  ConfirmedTicks nothing{3, 5000, 8, 0x01020304, LinkReport{1, 0, SlackReport{5009, 2}}, {}};
  EXPECT_LE(encode(nothing).size(), 40u);
  ConfirmedTicks eight = nothing;
  for (std::uint32_t i = 0; i < 8; ++i) eight.changes.push_back({5000 + i, i, pressing(2)});
  EXPECT_EQ(encode(eight).size(), encode(nothing).size() + 16);
}

TEST(ToClient, RefusesValuesOutOfRange) {
  const Welcome welcome{3, 7, 1, 16, kTicksPerSecond, "Platon"};
  const auto refused = [](const auto& message) { return !decodeToClient(encode(message)); };
  const auto changed = [&welcome](auto change) {
    Welcome copy = welcome;
    change(copy);
    return copy;
  };
  EXPECT_FALSE(refused(welcome));
  EXPECT_TRUE(refused(changed([](Welcome& w) { w.slot = 16; })));
  EXPECT_TRUE(refused(changed([](Welcome& w) { w.maxPlayers = kMaxPlayers + 1; })));
  EXPECT_TRUE(refused(changed([](Welcome& w) { w.maxPlayers = 0; })));
  EXPECT_TRUE(refused(changed([](Welcome& w) { w.ticksPerSecond = 50; })));
  EXPECT_TRUE(refused(changed([](Welcome& w) { w.serverName = "\x1b[2J"; })));
  EXPECT_TRUE(refused(Roster{{{1, "Ben"}, {kMaxPlayers, "Ann"}}}));
  EXPECT_TRUE(refused(Roster{{{1, "Ben"}, {2, "a\nb"}}}));
  EXPECT_TRUE(refused(Refused{RefusalCode::kFull, "a\nb"}));
  EXPECT_TRUE(refused(Refused{RefusalCode::kFull, "a", std::string(kMaxNextServerBytes + 1, 'a')}));
  EXPECT_TRUE(refused(Bye{ByeCode::kRemoved, "a", "a\nb"}));
  EXPECT_TRUE(refused(Bye{ByeCode::kRemoved, std::string(kMaxReasonBytes + 1, 'a')}));
  EXPECT_TRUE(refused(Notice{std::string(kMaxReasonBytes + 1, 'a')}));
  EXPECT_TRUE(refused(Notice{"a\nb"}));
  EXPECT_TRUE(refused(Notice{"\xff"}));
}

TEST(ToClient, RefusesAnEndOfTheRoundOutOfRange) {
  const RoundEnd valid{2, 3600, 18, "First steps", kMaxPauseTicks, LevelBest{kMaxBestTicks, "Ann", true}};
  const auto refused = [&valid](auto change) {
    RoundEnd copy = valid;
    change(copy);
    return !decodeToClient(encode(copy));
  };
  EXPECT_FALSE(refused([](RoundEnd&) {}));
  EXPECT_TRUE(refused([](RoundEnd& end) { end.nextTitle = "a\nb"; }));
  EXPECT_TRUE(refused([](RoundEnd& end) { end.nextTitle = std::string(kMaxTitleBytes + 1, 'a'); }));
  EXPECT_TRUE(refused([](RoundEnd& end) { end.pauseTicks = kMaxPauseTicks + 1; }));
  EXPECT_TRUE(refused([](RoundEnd& end) { end.best->ticks = kMaxBestTicks + 1; }));
  EXPECT_TRUE(refused([](RoundEnd& end) { end.best->name = "a\x1b"; }));
  EXPECT_TRUE(refused([](RoundEnd& end) { end.best->name = std::string(kMaxNameBytes + 1, 'a'); }));
}

TEST(ToClient, ABestTimeOfNoTicksIsNone) {
  EXPECT_EQ(decodeToClient(encode(RoundEnd{2, 3600, 18, "A", 300, LevelBest{0, "Ann", true}})),
            ToClient(RoundEnd{2, 3600, 18, "A", 300, std::nullopt}));
}

TEST(ToClient, RefusesMoreVotesThanVotersAndMoreVotersThanPlayers) {
  const auto refused = [](const VoteCount& count) { return !decodeToClient(encode(count)); };
  EXPECT_FALSE(refused({1, kMaxPlayers, kMaxPlayers}));
  EXPECT_TRUE(refused({1, 3, 2}));
  EXPECT_TRUE(refused({1, 1, kMaxPlayers + 1}));
}

// Encoded with the largest number, which is then raised, since `encode` asserts the range.
TEST(ToClient, RefusesRoundTripsOfMoreSlotsThanThereAre) {
  std::vector<std::uint8_t> bytes = encode(RoundTrips{std::vector<std::uint8_t>(kMaxPlayers, 13)});
  ASSERT_TRUE(decodeToClient(bytes));
  constexpr std::array<std::uint8_t, 4> kLength = {0, 1, 0, 0};
  const auto length = std::search(bytes.begin(), bytes.end(), kLength.begin(), kLength.end());
  ASSERT_NE(length, bytes.end());
  *length = 4;
  bytes.insert(bytes.end(), 4, 13);
  EXPECT_FALSE(decodeToClient(bytes));
}

// Changes the encoded byte, since `encode` asserts the range.
TEST(ToClient, RefusesALossAboveHundredPerCent) {
  const ConfirmedTicks message{3, 300, 8, 0, LinkReport{1, 100, std::nullopt}, {}};
  std::vector<std::uint8_t> bytes = encode(message);
  const auto lost = std::find(bytes.begin(), bytes.end(), 100);
  ASSERT_NE(lost, bytes.end());
  EXPECT_TRUE(decodeToClient(bytes));
  *lost = 101;
  EXPECT_FALSE(decodeToClient(bytes));
}

// Changes the encoded slack, since `encode` asserts the range. It is a varint: 2 + 2 |slack|, or 1 + 2 |slack| when
// negative.
TEST(ToClient, RefusesASlackOutOfRange) {
  for (const std::int32_t slack : {kMaxSlack, -kMaxSlack}) {
    std::vector<std::uint8_t> bytes =
        encode(ConfirmedTicks{3, 300, 8, 0, LinkReport{1, 0, SlackReport{300, slack}}, {}});
    const int number = slack > 0 ? 2002 : 2001;
    const std::array<std::uint8_t, 2> varint = {static_cast<std::uint8_t>(number % 128 + 128),
                                                static_cast<std::uint8_t>(number / 128)};
    const auto found = std::search(bytes.begin(), bytes.end(), varint.begin(), varint.end());
    ASSERT_NE(found, bytes.end());
    EXPECT_TRUE(decodeToClient(bytes));
    *found = static_cast<std::uint8_t>(*found + 2);  // one more in the same direction
    EXPECT_FALSE(decodeToClient(bytes)) << slack;
  }
}

TEST(ToClient, RefusesChunksBeyondTheirTotal) {
  const auto refused = [](std::uint32_t total, std::uint32_t offset, std::size_t size) {
    const std::vector<std::uint8_t> bytes(size);
    const bool level = decodeToClient(encode(LevelChunk{1, total, offset, bytes})).has_value();
    const bool state = decodeToClient(encode(StateChunk{1, 1, 1, total, offset, bytes})).has_value();
    EXPECT_EQ(level, state);
    return !level;
  };
  EXPECT_FALSE(refused(10, 0, 10));
  EXPECT_TRUE(refused(10, 0, 0));
  EXPECT_TRUE(refused(10, 1, 10));
  EXPECT_TRUE(refused(10, 11, 1));
  EXPECT_TRUE(refused(10, UINT32_MAX, 2));
  EXPECT_TRUE(refused(8192, 0, kChunkBytes + 1));
  EXPECT_TRUE(refused(kMaxLevelBytes + 1, 0, 1));
  EXPECT_FALSE(decodeToClient(encode(StateChunk{1, 1, 0, 1, 0, {1}})));
}

TEST(ToClient, UnknownCodesDecodeAsOther) {
  const auto refused = decodeToClient(encode(Refused{static_cast<RefusalCode>(77), "why"}));
  ASSERT_TRUE(refused);
  EXPECT_EQ(std::get<Refused>(*refused).code, RefusalCode::kOther);
  const auto bye = decodeToClient(encode(Bye{static_cast<ByeCode>(0), "why"}));
  ASSERT_TRUE(bye);
  EXPECT_EQ(std::get<Bye>(*bye).code, ByeCode::kOther);
}

TEST(ToClient, RefusesChangesOutOfOrderOrRange) {
  const auto refused = [](std::vector<InputChange> changes) {
    return !decodeToClient(encode(ConfirmedTicks{1, 10, 5, 0, std::nullopt, std::move(changes)}));
  };
  EXPECT_FALSE(refused({{10, 1, pressing(0)}, {14, 0, pressing(0)}}));
  EXPECT_TRUE(refused({{15, 0, pressing(0)}}));
  EXPECT_TRUE(refused({{10, 1, pressing(0)}, {10, 1, pressing(1)}}));
  EXPECT_TRUE(refused({{10, 2, pressing(0)}, {10, 1, pressing(0)}}));
}

TEST(RoundTripCode, EveryCodeButThatOfNoneIsTheCodeOfItsRoundTrip) {
  EXPECT_FALSE(roundTripOf(kNoRoundTrip));
  for (std::uint32_t code = 1; code <= UINT8_MAX; ++code) {
    const auto ms = roundTripOf(static_cast<std::uint8_t>(code));
    ASSERT_TRUE(ms);
    EXPECT_EQ(codeOfRoundTrip(*ms), code);
  }
}

TEST(RoundTripCode, IsRoundedToTheNearestStep) {
  for (std::uint32_t ms = 0; ms <= kMaxRoundTripMs; ++ms) {
    const auto read = roundTripOf(codeOfRoundTrip(ms));
    ASSERT_TRUE(read);
    EXPECT_LE(*read, ms + kRoundTripStepMs / 2);
    EXPECT_GE(*read + kRoundTripStepMs / 2, ms);
  }
}

TEST(RoundTripCode, ALongerOneIsTheLongest) {
  EXPECT_EQ(kMaxRoundTripMs, 1016u);
  EXPECT_EQ(roundTripOf(codeOfRoundTrip(kMaxRoundTripMs + 1)), kMaxRoundTripMs);
  EXPECT_EQ(codeOfRoundTrip(UINT32_MAX), UINT8_MAX);
}

// The slots 3 and 5 become twice 3, or lack the first one.
TEST(ToClient, NoTwoLocalPlayersHaveOneSlotAndTheFirstHasOne) {
  std::vector<std::uint8_t> bytes = encode(LocalSlots{{3, 5}});
  const std::array<std::uint8_t, 4> slots = {3, 5, 0, 0};
  const auto second = std::search(bytes.begin(), bytes.end(), slots.begin(), slots.end()) + 1;
  ASSERT_TRUE(decodeToClient(bytes));
  *second = 3;
  EXPECT_FALSE(decodeToClient(bytes));
  *second = 5;
  const std::array<std::uint8_t, 8> taken = {0, 0, 0, 3, 4, 0, 0, 0};
  const auto bits = std::search(bytes.begin(), bytes.end(), taken.begin(), taken.end()) + 3;
  ASSERT_LT(bits, bytes.end());
  *bits = 2;
  EXPECT_FALSE(decodeToClient(bytes));
  *bits = 3 + 16;
  EXPECT_FALSE(decodeToClient(bytes)) << "a fifth one";
}

}  // namespace
}  // namespace platon::to_client_test
