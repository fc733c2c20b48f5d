#include "protocol/loss_meter.h"

#include <gtest/gtest.h>

namespace platon::loss_meter_test {
namespace {

std::uint8_t number(int message) { return static_cast<std::uint8_t>(message); }

TEST(LossMeter, ReportsNoLossBeforeTheFirstMessage) {
  LossMeter meter;
  EXPECT_EQ(meter.lostPercent(), 0);
  meter.received(200);
  EXPECT_EQ(meter.lostPercent(), 0);
  EXPECT_EQ(meter.newest(), 200);
}

TEST(LossMeter, CountsLossOverTheLastHundredMessages) {
  LossMeter meter;
  for (int message = 250; message < 1250; ++message) {
    if (message % 5 != 0) meter.received(number(message));
  }
  EXPECT_EQ(meter.lostPercent(), 20);
  for (int message = 1250; message < 1350; ++message) meter.received(number(message));
  EXPECT_EQ(meter.lostPercent(), 0);
}

TEST(LossMeter, LateAndRepeatedMessagesCountAsReceived) {
  LossMeter meter;
  for (int message = 0; message < 300; message += 2) {
    meter.received(number(message + 1));
    meter.received(number(message));
    meter.received(number(message + 1));
  }
  EXPECT_EQ(meter.lostPercent(), 0);
  EXPECT_EQ(meter.newest(), number(299));
}

TEST(LossMeter, ALongGapCountsAsLoss) {
  LossMeter meter;
  meter.received(0);
  meter.received(150);
  EXPECT_EQ(meter.newest(), 150);
  EXPECT_EQ(meter.lostPercent(), 99);
  meter.received(40);  // 146 ahead rather than 110 back
  EXPECT_EQ(meter.newest(), 40);
}

TEST(LossMeter, CountsLossOverAllMessagesUntilThereAreAHundred) {
  LossMeter meter;
  meter.received(10);
  meter.received(13);
  EXPECT_EQ(meter.lostPercent(), 50);
}

TEST(LossMeter, IgnoresMessagesBeforeTheWindow) {
  LossMeter meter;
  meter.received(10);
  meter.received(9);
  EXPECT_EQ(meter.lostPercent(), 0);
  for (int message = 11; message < 200; ++message) meter.received(number(message));
  meter.received(number(199 - 99));
  EXPECT_EQ(meter.lostPercent(), 0);
  EXPECT_EQ(meter.newest(), 199);
}

}  // namespace
}  // namespace platon::loss_meter_test
