#include "client/netcode/link_meter.h"

#include <gtest/gtest.h>

#include <optional>

namespace platon {
namespace {

using std::chrono::milliseconds;

class LineMeterTest : public testing::Test {
 protected:
  // Sends a message of inputs; its number.
  std::uint8_t send(int ms) { return meter_.send(milliseconds(ms)); }

  // The next message of ticks comes, and tells of the message `heard` of inputs.
  void hear(int ms, std::optional<std::uint8_t> heard, std::uint8_t lost = 0) {
    ConfirmedTicks message;
    message.sequence = sequence_++;
    if (heard) message.link = LinkReport{*heard, lost, {}};
    meter_.receive(message, milliseconds(ms));
  }

  void loseTicks(std::uint8_t count) { sequence_ = static_cast<std::uint8_t>(sequence_ + count); }

  LinkMeter meter_;
  std::uint8_t sequence_ = 200;  // so that it wraps, too
};

TEST_F(LineMeterTest, KnowsNothingAtFirst) {
  EXPECT_EQ(meter_.roundTrip(), Moment{});
  EXPECT_EQ(meter_.lostDownPercent(), 0u);
  EXPECT_EQ(meter_.lostUpPercent(), 0u);
  hear(10, std::nullopt);
  EXPECT_EQ(meter_.roundTrip(), Moment{});
}

TEST_F(LineMeterTest, TakesTheFirstSampleAndAnEighthOfTheFurther) {
  hear(90, send(10));
  EXPECT_EQ(meter_.roundTrip(), milliseconds(80));
  hear(260, send(100));
  EXPECT_EQ(meter_.roundTrip(), milliseconds(90));  // 80 + (160 − 80) / 8
  hear(310, send(300));
  EXPECT_EQ(meter_.roundTrip(), milliseconds(80));  // 90 + (10 − 90) / 8
}

TEST_F(LineMeterTest, AnEchoCountsOnce) {
  const std::uint8_t first = send(0), second = send(10);
  hear(50, second);
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
  hear(500, second);
  hear(600, first);  // overtaken
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
}

TEST_F(LineMeterTest, ALateEchoDoesNotBringOldLossesBack) {
  const std::uint8_t first = send(0), second = send(10);
  hear(50, second, 7);
  hear(60, first, 90);
  EXPECT_EQ(meter_.lostUpPercent(), 7u);
}

TEST_F(LineMeterTest, WhatWasNeverSentIsIgnored) {
  hear(50, 0, 99);
  hear(60, send(20), 3);
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
  for (const int never : {1, 2, 127, 128, 255}) hear(1000, static_cast<std::uint8_t>(never), 99);
  EXPECT_EQ(meter_.roundTrip(), milliseconds(40));
  EXPECT_EQ(meter_.lostUpPercent(), 3u);
}

TEST_F(LineMeterTest, NumbersWrap) {
  for (int i = 0; i < 1000; ++i) {
    const std::uint8_t number = send(100 * i);
    ASSERT_EQ(number, i % 256);
    hear(100 * i + 30, number);
    ASSERT_EQ(meter_.roundTrip(), milliseconds(30)) << i;
  }
}

// A line on which up to 255 messages are under way.
TEST_F(LineMeterTest, MeasuresLongRoundTrips) {
  for (int i = 0; i < 600; ++i) {
    send(10 * i);
    if (i < 254) continue;
    hear(10 * i + 5, static_cast<std::uint8_t>(i - 254));
    ASSERT_EQ(meter_.roundTrip(), milliseconds(2545)) << i;
  }
}

TEST_F(LineMeterTest, CountsWhatIsLostOfTheLastHundred) {
  for (int i = 0; i < 50; ++i) hear(i, std::nullopt);
  EXPECT_EQ(meter_.lostDownPercent(), 0u);
  loseTicks(10);
  for (int i = 0; i < 40; ++i) hear(100 + i, std::nullopt);
  EXPECT_EQ(meter_.lostDownPercent(), 10u);
  for (int i = 0; i < 100; ++i) hear(200 + i, std::nullopt);
  EXPECT_EQ(meter_.lostDownPercent(), 0u);
  hear(400, send(390), 17);
  EXPECT_EQ(meter_.lostUpPercent(), 17u);
}

}  // namespace
}  // namespace platon
