#include "client/netcode/link_meter.h"

#include <gtest/gtest.h>

#include <optional>

namespace platon::link_meter_test {
namespace {

using std::chrono::milliseconds;

class LinkMeterTest : public testing::Test {
 protected:
  // Sends a PlayerInputs message and returns its sequence number.
  std::uint8_t send(int ms) { return meter_.nextSequence(milliseconds(ms)); }

  // Receives the next ConfirmedTicks message, which reports the PlayerInputs message `reported`.
  void receive(int ms, std::optional<std::uint8_t> reported, std::uint8_t lost = 0) {
    ConfirmedTicks message;
    message.sequence = sequence_++;
    if (reported) message.link = LinkReport{*reported, lost, {}};
    meter_.receive(message, milliseconds(ms));
  }

  void loseTicks(std::uint8_t count) { sequence_ = static_cast<std::uint8_t>(sequence_ + count); }

  LinkMeter meter_;
  std::uint8_t sequence_ = 200;  // wraps during the tests
};

TEST_F(LinkMeterTest, IsZeroAtFirst) {
  EXPECT_EQ(meter_.roundTrip(), Time{});
  EXPECT_EQ(meter_.lostDownPercent(), 0u);
  EXPECT_EQ(meter_.lostUpPercent(), 0u);
  receive(10, std::nullopt);
  EXPECT_EQ(meter_.roundTrip(), Time{});
}

TEST_F(LinkMeterTest, SmoothsTheRoundTripByAnEighth) {
  receive(90, send(10));
  EXPECT_EQ(meter_.roundTrip(), milliseconds(80));
  receive(260, send(100));
  EXPECT_EQ(meter_.roundTrip(), milliseconds(90));  // 80 + (160 − 80) / 8
  receive(310, send(300));
  EXPECT_EQ(meter_.roundTrip(), milliseconds(80));  // 90 + (10 − 90) / 8
}

TEST_F(LinkMeterTest, CountsEachReportOnce) {
  const std::uint8_t first = send(0);
  const std::uint8_t second = send(10);
  receive(50, second);
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
  receive(500, second);
  receive(600, first);  // overtaken
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
}

TEST_F(LinkMeterTest, IgnoresTheLossOfAnOvertakenReport) {
  const std::uint8_t first = send(0), second = send(10);
  receive(50, second, 7);
  receive(60, first, 90);
  EXPECT_EQ(meter_.lostUpPercent(), 7u);
}

TEST_F(LinkMeterTest, IgnoresNumbersNeverSent) {
  receive(50, 0, 99);
  receive(60, send(20), 3);
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
  for (const int never : {1, 2, 127, 128, 255}) receive(1000, static_cast<std::uint8_t>(never), 99);
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
  EXPECT_EQ(meter_.lostUpPercent(), 3u);
}

TEST_F(LinkMeterTest, SequenceNumbersWrap) {
  for (int i = 0; i < 1000; ++i) {
    const std::uint8_t number = send(100 * i);
    ASSERT_EQ(number, i % 256);
    receive(100 * i + 30, number);
    ASSERT_EQ(meter_.roundTrip(), milliseconds(30)) << i;
  }
}

// With 255 messages in flight.
TEST_F(LinkMeterTest, MeasuresLongRoundTrips) {
  for (int i = 0; i < 600; ++i) {
    send(10 * i);
    if (i < 254) continue;
    receive(10 * i + 5, static_cast<std::uint8_t>(i - 254));
    ASSERT_EQ(meter_.roundTrip(), milliseconds(2545)) << i;
  }
}

TEST_F(LinkMeterTest, CountsLossesAmongTheLastHundredMessages) {
  for (int i = 0; i < 50; ++i) receive(i, std::nullopt);
  EXPECT_EQ(meter_.lostDownPercent(), 0u);
  loseTicks(10);
  for (int i = 0; i < 40; ++i) receive(100 + i, std::nullopt);
  EXPECT_EQ(meter_.lostDownPercent(), 10u);
  for (int i = 0; i < 100; ++i) receive(200 + i, std::nullopt);
  EXPECT_EQ(meter_.lostDownPercent(), 0u);
  receive(400, send(390), 17);
  EXPECT_EQ(meter_.lostUpPercent(), 17u);
}

ConfirmedTicks confirmed(std::uint32_t from, LinkReport report) {
  ConfirmedTicks message;
  message.from = from;
  message.count = 1;
  message.link = report;
  return message;
}

TEST(LinkStatistics, ConvertsToDisplayUnits) {
  LinkMeter meter;
  PredictionClock clock(6);
  const std::uint8_t sequence = meter.nextSequence(milliseconds(100));
  clock.receive(confirmed(9, {sequence, 3, std::nullopt}), milliseconds(100));
  for (int ms = 110; ms <= 1000; ms += 10) {
    const auto next = static_cast<std::uint32_t>(clock.tick());
    clock.update(milliseconds(ms), next);
    if (clock.reaches(next)) clock.inputChosen(next);
  }
  // Two samples of the required lead, six ticks apart: 100 ms.
  clock.receive(confirmed(40, {sequence, 3, SlackReport{30, 8}}), milliseconds(1000));
  clock.receive(confirmed(41, {sequence, 3, SlackReport{31, 2}}), milliseconds(1000));
  meter.receive(confirmed(41, {sequence, 3, SlackReport{31, 2}}), milliseconds(180));
  const LinkStatistics statistics = meter.statistics(&clock);
  EXPECT_DOUBLE_EQ(statistics.rttMs, 80);
  EXPECT_NEAR(statistics.jitterMs, 100, 1e-6);
  EXPECT_EQ(statistics.slackTicks, 2);
  EXPECT_EQ(statistics.lostUpPercent, 3);
  EXPECT_EQ(statistics.lostDownPercent, 0);
}

TEST(LinkStatistics, WithoutAClockHasOnlyTheValuesOfTheMeter) {
  LinkMeter meter;
  meter.receive(confirmed(0, {meter.nextSequence(milliseconds(1)), 7, SlackReport{0, 4}}), milliseconds(21));
  const LinkStatistics statistics = meter.statistics(nullptr);
  EXPECT_DOUBLE_EQ(statistics.rttMs, 20);
  EXPECT_EQ(statistics.lostUpPercent, 7);
  EXPECT_EQ(statistics.jitterMs, 0);
  EXPECT_EQ(statistics.slackTicks, 0);
}

}  // namespace
}  // namespace platon::link_meter_test
