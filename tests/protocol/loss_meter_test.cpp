#include "protocol/loss_meter.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon {
namespace {

std::uint8_t number(int message) { return static_cast<std::uint8_t>(message); }

TEST(LossMeter, KnowsNothingBeforeTheFirst) {
  LossMeter meter;
  EXPECT_EQ(meter.lostPercent(), 0);
  meter.heard(200);
  EXPECT_EQ(meter.lostPercent(), 0);
  EXPECT_EQ(meter.newest(), 200);
}

TEST(LossMeter, CountsWhatIsMissingOfTheLastHundred) {
  LossMeter meter;
  for (int message = 250; message < 1250; ++message) {
    if (message % 5 != 0) meter.heard(number(message));
  }
  EXPECT_EQ(meter.lostPercent(), 20);
  for (int message = 1250; message < 1350; ++message) meter.heard(number(message));
  EXPECT_EQ(meter.lostPercent(), 0);
}

TEST(LossMeter, TakesOvertakenAndRepeatedMessagesForHeard) {
  LossMeter meter;
  for (int message = 0; message < 300; message += 2) {
    meter.heard(number(message + 1));
    meter.heard(number(message));
    meter.heard(number(message + 1));
  }
  EXPECT_EQ(meter.lostPercent(), 0);
  EXPECT_EQ(meter.newest(), number(299));
}

TEST(LossMeter, ALongGapIsAllLoss) {
  LossMeter meter;
  meter.heard(0);
  meter.heard(150);
  EXPECT_EQ(meter.newest(), 150);
  EXPECT_EQ(meter.lostPercent(), 99);
  meter.heard(40);  // 146 ahead rather than 110 back
  EXPECT_EQ(meter.newest(), 40);
}

// A share of those since the first, as long as there are fewer than a hundred.
TEST(LossMeter, BeginsWithWhatItHas) {
  LossMeter meter;
  meter.heard(10);
  meter.heard(13);
  EXPECT_EQ(meter.lostPercent(), 50);
}

// What came before the first one, or too late to be looked back on, says nothing.
TEST(LossMeter, LeavesOutWhatIsTooOld) {
  LossMeter meter;
  meter.heard(10);
  meter.heard(9);
  EXPECT_EQ(meter.lostPercent(), 0);
  for (int message = 11; message < 200; ++message) meter.heard(number(message));
  meter.heard(number(199 - 99));
  EXPECT_EQ(meter.lostPercent(), 0);
  EXPECT_EQ(meter.newest(), 199);
}

}  // namespace
}  // namespace platon
