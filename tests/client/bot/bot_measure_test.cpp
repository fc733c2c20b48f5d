#include <gtest/gtest.h>

#include "client/bot/bot_measure.h"

namespace platon::bot_measure_test {
namespace {

using std::chrono::seconds;

PredictionStatistics statisticsOf(std::uint32_t ticks, std::uint32_t corrections, std::int32_t largest) {
  PredictionStatistics statistics;
  statistics.confirmedTicks = ticks;
  statistics.corrections = corrections;
  statistics.missedInputs = 2 * corrections;
  statistics.mispredicted = 3 * corrections;
  statistics.maxSubunits = largest;
  return statistics;
}

TEST(BotMeasure, StartsWithTheFirstConfirmedTick) {
  BotMeasure measure(seconds(10), Moment{});
  measure.update(seconds(11), statisticsOf(0, 0, 0), {100, 1, 200, 2, 90});
  EXPECT_FALSE(measure.result(statisticsOf(0, 0, 0), {100, 1, 200, 2, 90}).joined);
  measure.update(seconds(12), statisticsOf(3, 0, 0), {110, 2, 220, 3, 900});
  measure.update(seconds(16), statisticsOf(243, 1, 70), {510, 12, 820, 23, 900});
  const BotResult result = measure.result(statisticsOf(243, 1, 70), {510, 12, 820, 23, 900});
  EXPECT_TRUE(result.joined);
  EXPECT_DOUBLE_EQ(result.connectMs, 2000);
  EXPECT_DOUBLE_EQ(result.seconds, 4);
  EXPECT_EQ(result.traffic.sentBytes, 400u);
  EXPECT_EQ(result.traffic.receivedPackets, 20u);
  EXPECT_EQ(result.traffic.longestDatagram, 900u);
  EXPECT_EQ(result.prediction.confirmedTicks, 243u);
  EXPECT_EQ(result.prediction.corrections, 1u);
}

TEST(BotMeasure, ExcludesTheSettlingTime) {
  BotMeasure measure(seconds(0), seconds(3));
  measure.update(seconds(1), statisticsOf(1, 0, 0), {});
  measure.update(seconds(3), statisticsOf(120, 5, 800), {100, 1, 200, 2, 90});
  EXPECT_EQ(measure.result(statisticsOf(120, 5, 800), {}).seconds, 0);
  EXPECT_EQ(measure.result(statisticsOf(120, 5, 800), {}).prediction.confirmedTicks, 0u);
  measure.update(seconds(4), statisticsOf(180, 6, 800), {110, 1, 200, 2, 90});
  measure.update(seconds(6), statisticsOf(300, 8, 800), {310, 2, 200, 2, 90});
  const BotResult result = measure.result(statisticsOf(300, 8, 800), {310, 2, 200, 2, 90});
  EXPECT_DOUBLE_EQ(result.seconds, 2);
  EXPECT_EQ(result.traffic.sentBytes, 200u);
  EXPECT_EQ(result.prediction.confirmedTicks, 120u);
  EXPECT_EQ(result.prediction.corrections, 2u);
  EXPECT_EQ(result.prediction.missedInputs, 4u);
  EXPECT_EQ(result.prediction.mispredicted, 6u);
  EXPECT_EQ(result.prediction.maxSubunits, 800);  // of the whole run
}

}  // namespace
}  // namespace platon::bot_measure_test
