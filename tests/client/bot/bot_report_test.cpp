#include "client/bot/bot_report.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace platon::bot_report_test {
namespace {

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

}  // namespace
}  // namespace platon::bot_report_test
