#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "client/bot/bot_measure.h"

namespace platon {

/// Averages over the bots that played to the end; zero if there are none.
struct BotReport {
  std::uint32_t connected = 0;  ///< bots that played to the end
  std::uint32_t failed = 0;     ///< all others
  double connectMs = 0;
  double rttMs = 0;
  double jitterMs = 0;    ///< as LinkStatistics
  double slackTicks = 0;  ///< as LinkStatistics
  double downLossPercent = 0;
  double upLossPercent = 0;
  double downBytesPerSecond = 0;  ///< UDP payload
  double upBytesPerSecond = 0;
  double downPacketsPerSecond = 0;
  double upPacketsPerSecond = 0;
  double correctionsPer1000Ticks = 0;
  double maxCorrectionSubunits = 0;
  double mispredictedPer1000Ticks = 0;
  double missedInputsPer1000Ticks = 0;
  double desyncs = 0;
  double resyncs = 0;
  double confirmedTicks = 0;
  double resumes = 0;
  std::uint64_t longestDatagramBytes = 0;  ///< maximum of all bots over the whole run, UDP payload
  bool hollow = false;                     ///< hollow bots: statistics of the game are unknown
};

BotReport makeReport(std::span<const BotResult> bots);

/// One JSON object. Statistics that hollow bots do not know are null.
std::string toJson(const BotReport& report);
/// A human-readable table.
std::string toText(const BotReport& report);

}  // namespace platon
