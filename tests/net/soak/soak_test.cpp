#include "tests/net/soak/soak.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace platon::soak_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr std::int64_t kMegabyte = 1024 * 1024;

bool isFull() { return std::getenv("PLATON_LONG") != nullptr; }

// No roll call is due when the players come back.
SoakPlan plan() {
  if (isFull()) return {hours(8), minutes(33), minutes(927), minutes(5)};
  return {seconds(200), seconds(70), seconds(330), seconds(100)};
}

void print(const SoakReport& report) {
  std::printf("%s\n", report.text().c_str());
  std::fflush(stdout);
}

void expectNothingLost(const SoakReport& report) {
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_EQ(report.absent, 0u);
  EXPECT_EQ(report.desyncs, 0u);
  EXPECT_EQ(report.missedInputs, 0u);
  EXPECT_EQ(report.corrections, 0u);
  // Lost connections, and what clients say to a server that has closed theirs.
  for (const auto& [reason, count] : report.rejected) EXPECT_TRUE(reason == "silent" || reason == "seal") << reason;
}

void expectMuchDone(const SoakReport& report) {
  const Time played = plan().shortRounds + plan().longRounds;
  EXPECT_GE(report.ticks, static_cast<std::uint64_t>((played - seconds(2)) / seconds(1)) * kTicksPerSecond);
  EXPECT_GE(report.rollCalls, 5u);
  const auto turns = static_cast<std::uint64_t>(played / minutes(1)) * 10;
  EXPECT_GE(report.counts.joins, turns);
  EXPECT_GE(report.counts.leaves, turns);
  EXPECT_GE(report.counts.resumes, turns / 2);
  EXPECT_GE(report.rounds, static_cast<std::uint64_t>(plan().shortRounds / seconds(20)));
  // The seal sends 14 bits of the sequence numbers; ENet counts 16 bits of packets and 32 bits of milliseconds.
  EXPECT_GT(report.longestTraffic.sentPackets, 1u << (isFull() ? 20 : 14));
  EXPECT_GT(report.longestTraffic.receivedPackets, 1u << (isFull() ? 20 : 13));
  EXPECT_EQ(report.longestRound, kRoundTicks + MatchRounds::kPauseTicks - 1);
}

TEST(Soak, PlayersComeAndGoAndLeaveNoTrace) {
  const SoakReport report = Soak(plan()).run(print);
  print(report);
  expectNothingLost(report);
  expectMuchDone(report);
  EXPECT_LE(report.serverGrowth, kMegabyte);
  EXPECT_LE(report.idleGrowth, kMegabyte);
}

}  // namespace
}  // namespace platon::soak_test
