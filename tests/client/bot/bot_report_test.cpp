#include "client/bot/bot_report.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace platon::bot_report_test {
namespace {

using std::chrono::seconds;

BotResult played(std::uint32_t ticks, std::uint32_t corrections) {
  BotResult bot;
  bot.joined = true;
  bot.connectMs = 40;
  bot.seconds = 10;
  bot.traffic = {12000, 300, 30000, 600, 1000 + corrections};
  bot.prediction.confirmedTicks = ticks;
  bot.prediction.corrections = corrections;
  bot.prediction.maxSubunits = static_cast<std::int32_t>(corrections) * 100;
  return bot;
}

TEST(BotReport, AveragesOverTheBotsThatPlayedToTheEnd) {
  BotResult dropped = played(1, 1000);
  dropped.ending = "gone";
  const std::vector<BotResult> bots = {played(1000, 0), dropped, played(500, 3), BotResult()};
  const BotReport report = makeReport(bots);
  EXPECT_EQ(report.connected, 2u);
  EXPECT_EQ(report.failed, 2u);
  EXPECT_DOUBLE_EQ(report.connectMs, 40);
  EXPECT_DOUBLE_EQ(report.upBytesPerSecond, 1200);
  EXPECT_DOUBLE_EQ(report.downBytesPerSecond, 3000);
  EXPECT_DOUBLE_EQ(report.upPacketsPerSecond, 30);
  EXPECT_DOUBLE_EQ(report.downPacketsPerSecond, 60);
  EXPECT_DOUBLE_EQ(report.correctionsPer1000Ticks, 3);  // 0 and 6
  EXPECT_DOUBLE_EQ(report.maxCorrectionSubunits, 150);
  EXPECT_DOUBLE_EQ(report.confirmedTicks, 750);
  EXPECT_EQ(report.longestDatagramBytes, 1003u);  // maximum, not average
}

// Each of its own size, so that none is taken for another.
TEST(BotReport, AveragesEveryStatisticOfTheLinkAndOfTheGame) {
  BotResult low = played(1000, 0);
  low.link = {10, 1, -2, 4, 8};
  BotResult high = played(1000, 0);
  high.link = {30, 5, 8, 14, 28};
  high.prediction.mispredicted = 6;
  high.prediction.missedInputs = 10;
  high.round.desyncs = 12;
  high.round.resyncs = 14;
  high.resumes = 16;
  const std::vector<BotResult> bots{low, high};
  const BotReport report = makeReport(bots);
  EXPECT_DOUBLE_EQ(report.rttMs, 20);
  EXPECT_DOUBLE_EQ(report.jitterMs, 3);
  EXPECT_DOUBLE_EQ(report.slackTicks, 3);
  EXPECT_DOUBLE_EQ(report.downLossPercent, 9);
  EXPECT_DOUBLE_EQ(report.upLossPercent, 18);
  EXPECT_DOUBLE_EQ(report.mispredictedPer1000Ticks, 3);
  EXPECT_DOUBLE_EQ(report.missedInputsPer1000Ticks, 5);
  EXPECT_DOUBLE_EQ(report.desyncs, 6);
  EXPECT_DOUBLE_EQ(report.resyncs, 7);
  EXPECT_DOUBLE_EQ(report.resumes, 8);
}

TEST(BotReport, IsZeroWithoutAnyBot) {
  const BotReport report = makeReport({});
  EXPECT_EQ(report.connected, 0u);
  EXPECT_EQ(report.failed, 0u);
  EXPECT_EQ(report.rttMs, 0);
}

TEST(BotReport, JsonHasExactlyTheDocumentedKeys) {
  EXPECT_EQ(toJson(BotReport()),
            "{\"connected\":0,\"failed\":0,\"connectMs\":0,\"rttMs\":0,\"jitterMs\":0,\"slackTicks\":0,"
            "\"downLossPercent\":0,\"upLossPercent\":0,\"downBytesPerSecond\":0,\"upBytesPerSecond\":0,"
            "\"downPacketsPerSecond\":0,\"upPacketsPerSecond\":0,\"correctionsPer1000Ticks\":0,"
            "\"maxCorrectionSubunits\":0,\"mispredictedPer1000Ticks\":0,\"missedInputsPer1000Ticks\":0,"
            "\"hashMismatches\":0,\"resyncs\":0,\"confirmedTicks\":0,\"resumes\":0,\"longestDatagramBytes\":0}\n");
}

TEST(BotReport, StatisticsUnknownToHollowBotsAreNull) {
  BotReport report;
  report.hollow = true;
  const std::string json = toJson(report);
  for (const char* const key : {"correctionsPer1000Ticks", "maxCorrectionSubunits", "mispredictedPer1000Ticks",
                                "missedInputsPer1000Ticks", "hashMismatches", "resyncs", "resumes"}) {
    EXPECT_NE(json.find("\"" + std::string(key) + "\":null"), std::string::npos) << json;
  }
  EXPECT_NE(json.find("\"confirmedTicks\":0,"), std::string::npos) << json;
  EXPECT_EQ(toText(report).find("resyncs"), std::string::npos);
}

TEST(BotReport, TextShowsFailedBots) {
  BotReport report;
  report.failed = 3;
  EXPECT_NE(toText(report).find("3 failed"), std::string::npos);
}

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
  BotMeasure measure(seconds(10), Time{});
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
}  // namespace platon::bot_report_test
