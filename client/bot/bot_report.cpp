#include "client/bot/bot_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace platon {

void BotMeasure::update(Time now, const PredictionStatistics& prediction, const Traffic& traffic) {
  now_ = now;
  if (!playingSince_ && prediction.confirmedTicks > 0) playingSince_ = now;
  if (!playingSince_ || measuredSince_ || now - *playingSince_ < settle_) return;
  measuredSince_ = now;
  if (settle_ > Time{}) predictionBefore_ = prediction;
  trafficBefore_ = traffic;
}

BotResult BotMeasure::result(const PredictionStatistics& prediction, const Traffic& traffic) const {
  BotResult result;
  result.joined = playingSince_.has_value();
  if (!result.joined) return result;
  result.connectMs = toSeconds(*playingSince_ - startedAt_) * 1000;
  if (!measuredSince_) return result;
  result.seconds = toSeconds(now_ - *measuredSince_);
  result.traffic = traffic - trafficBefore_;
  result.prediction = prediction - predictionBefore_;
  return result;
}

namespace {

struct Field {
  const char* name;
  double BotReport::*value;
  const char* meaning;
  bool needsGame = false;  // unknown to hollow bots
};

constexpr std::array<Field, 18> kFields = {{
    {"connectMs", &BotReport::connectMs, "time to join, ms"},
    {"rttMs", &BotReport::rttMs, "round trip, ms"},
    {"jitterMs", &BotReport::jitterMs, "jitter, ms"},
    {"slackTicks", &BotReport::slackTicks, "input slack, ticks"},
    {"downLossPercent", &BotReport::downLossPercent, "loss down, %"},
    {"upLossPercent", &BotReport::upLossPercent, "loss up, %"},
    {"downBytesPerSecond", &BotReport::downBytesPerSecond, "down, bytes/s"},
    {"upBytesPerSecond", &BotReport::upBytesPerSecond, "up, bytes/s"},
    {"downPacketsPerSecond", &BotReport::downPacketsPerSecond, "down, packets/s"},
    {"upPacketsPerSecond", &BotReport::upPacketsPerSecond, "up, packets/s"},
    {"correctionsPer1000Ticks", &BotReport::correctionsPer1000Ticks, "corrections per 1000 ticks", true},
    {"maxCorrectionSubunits", &BotReport::maxCorrectionSubunits, "largest correction, subunits", true},
    {"mispredictedPer1000Ticks", &BotReport::mispredictedPer1000Ticks, "mispredictions per 1000 ticks", true},
    {"missedInputsPer1000Ticks", &BotReport::missedInputsPer1000Ticks, "missed inputs per 1000 ticks", true},
    {"hashMismatches", &BotReport::desyncs, "desyncs", true},
    {"resyncs", &BotReport::resyncs, "resyncs", true},
    {"confirmedTicks", &BotReport::confirmedTicks, "confirmed ticks"},
    {"resumes", &BotReport::resumes, "resumes", true},
}};

void add(BotReport& sum, const BotResult& bot) {
  const double seconds = std::max(bot.seconds, 1e-3);
  const double thousands = std::max(bot.prediction.confirmedTicks, 1u) / 1000.0;
  sum.connectMs += bot.connectMs;
  sum.rttMs += bot.link.rttMs;
  sum.jitterMs += bot.link.jitterMs;
  sum.slackTicks += bot.link.slackTicks;
  sum.downLossPercent += bot.link.lostDownPercent;
  sum.upLossPercent += bot.link.lostUpPercent;
  sum.downBytesPerSecond += static_cast<double>(bot.traffic.receivedBytes) / seconds;
  sum.upBytesPerSecond += static_cast<double>(bot.traffic.sentBytes) / seconds;
  sum.downPacketsPerSecond += static_cast<double>(bot.traffic.receivedPackets) / seconds;
  sum.upPacketsPerSecond += static_cast<double>(bot.traffic.sentPackets) / seconds;
  sum.correctionsPer1000Ticks += bot.prediction.corrections / thousands;
  sum.maxCorrectionSubunits += bot.prediction.maxSubunits;
  sum.mispredictedPer1000Ticks += bot.prediction.mispredicted / thousands;
  sum.missedInputsPer1000Ticks += bot.prediction.missedInputs / thousands;
  sum.desyncs += bot.round.desyncs;
  sum.resyncs += bot.round.resyncs;
  sum.confirmedTicks += bot.prediction.confirmedTicks;
  sum.resumes += bot.resumes;
  sum.longestDatagramBytes = std::max(sum.longestDatagramBytes, bot.traffic.longestDatagram);
}

}  // namespace

BotReport makeReport(std::span<const BotResult> bots) {
  BotReport report;
  for (const BotResult& bot : bots) {
    const bool played = bot.joined && !bot.ending;
    ++(played ? report.connected : report.failed);
    if (played) add(report, bot);
  }
  if (report.connected == 0) return report;
  for (const Field& field : kFields) report.*field.value /= report.connected;
  return report;
}

std::string toJson(const BotReport& report) {
  std::string json = fmt::format("{{\"connected\":{},\"failed\":{}", report.connected, report.failed);
  for (const Field& field : kFields) {
    const bool known = !field.needsGame || !report.hollow;
    json += fmt::format(",\"{}\":{}", field.name, known ? fmt::format("{:.6g}", report.*field.value) : "null");
  }
  return json + fmt::format(",\"longestDatagramBytes\":{}}}\n", report.longestDatagramBytes);
}

std::string toText(const BotReport& report) {
  std::string text = fmt::format("{} bots played to the end, {} failed. Averages:\n", report.connected, report.failed);
  for (const Field& field : kFields) {
    if (field.needsGame && report.hollow) continue;
    text += fmt::format("  {:<30}{:>10.1f}\n", field.meaning, report.*field.value);
  }
  return text + fmt::format("  {:<30}{:>8}\n", "longest datagram, bytes", report.longestDatagramBytes);
}

}  // namespace platon
