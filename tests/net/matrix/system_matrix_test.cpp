#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/pressing.h"
#include "tests/support/test_level.h"
#include "tests/support/virtual_match.h"

namespace platon {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 20261122;
constexpr std::size_t kPlayers = 16;
constexpr Moment kSettling = seconds(10);
constexpr Moment kMeasured = seconds(12);

// Of all players together.
struct Counts {
  double confirmed = 0;
  double missed = 0;
  double mispredicted = 0;
  std::uint32_t desyncs = 0;
  std::uint32_t resyncs = 0;

  friend Counts operator-(const Counts& a, const Counts& b) {
    return {a.confirmed - b.confirmed, a.missed - b.missed, a.mispredicted - b.mispredicted, a.desyncs - b.desyncs,
            a.resyncs - b.resyncs};
  }
};

Counts countsOf(const VirtualMatch& match) {
  Counts counts;
  for (std::size_t player = 0; player < kPlayers; ++player) {
    const PredictionStatistics prediction = match.session(player).predictionStatistics();
    const RoundStatistics round = match.session(player).roundStatistics();
    counts.confirmed += prediction.confirmedTicks;
    counts.missed += prediction.missedInputs;
    counts.mispredicted += prediction.mispredicted;
    counts.desyncs += round.desyncs;
    counts.resyncs += round.resyncs;
  }
  return counts;
}

/// Loss in per cent, delay and jitter in milliseconds, each way.
class Matrix : public testing::TestWithParam<std::tuple<double, double, double>> {
 protected:
  static LinkQuality line() {
    LinkQuality line;
    std::tie(line.lossPercent, line.delayMs, line.jitterMs) = GetParam();
    return line;
  }

  static double percent(double part, double whole) { return 100 * part / whole; }

  // What lies between the server's tick and the newest a client can have: the way, its jitter, the server's pause
  // between messages, and the next few when one is lost.
  static double ticksOnTheWay() {
    const double wayMs = line().delayMs + line().jitterMs;
    return wayMs * kTicksPerSecond / 1000 + 2 + (line().lossPercent > 0 ? 10 : 0);
  }

  static void expectInStep(VirtualMatch& match) {
    for (std::size_t player = 0; player < kPlayers; ++player) {
      const Round* const round = match.session(player).round();
      ASSERT_NE(round, nullptr);
      EXPECT_EQ(round->id(), match.match().round());
      EXPECT_TRUE(round->prediction().present());
      EXPECT_GE(round->prediction().confirmedTicks() + ticksOnTheWay(), match.match().game().tick()) << player;
    }
  }
};

// Sixteen players on such lines: that every confirmed game is the server's is checked by VirtualMatch at every update.
TEST_P(Matrix, InputsArriveInTimeAndGamesStayInLockstep) {
  VirtualMatch match({endlessLevel()}, kSeed);
  for (std::size_t player = 0; player < kPlayers; ++player) {
    match.join(line(), pressing(kSeed + player));
    match.run(milliseconds(60));
  }
  match.run(kSettling);
  const Counts before = countsOf(match);
  match.run(kMeasured);
  const Counts all = countsOf(match);
  const Counts counts = all - before;
  expectInStep(match);
  EXPECT_EQ(all.desyncs, 0u);
  EXPECT_EQ(all.resyncs, 0u);
  EXPECT_GT(counts.confirmed, kPlayers * (toSeconds(kMeasured) * kTicksPerSecond - ticksOnTheWay()));
  if (line().lossPercent <= 10) {
    EXPECT_LT(percent(counts.missed, counts.confirmed), 0.1);
  }
  if (line().lossPercent <= 2) {
    EXPECT_LT(percent(counts.mispredicted, counts.confirmed), 0.5);
  }
  std::printf("loss %g %%, delay %g ms, jitter %g ms: missed %.4f %%, mispredicted %.4f %% (seed %llu)\n",
              line().lossPercent, line().delayMs, line().jitterMs, percent(counts.missed, counts.confirmed),
              percent(counts.mispredicted, counts.confirmed), static_cast<unsigned long long>(kSeed));
}

std::string nameOf(const testing::TestParamInfo<Matrix::ParamType>& test) {
  const auto whole = [](double value) { return std::to_string(static_cast<int>(value)); };
  const auto [loss, delay, jitter] = test.param;
  return "Loss" + whole(loss) + "Delay" + whole(delay) + "Jitter" + whole(jitter);
}

using Conditions = Matrix::ParamType;

std::vector<Conditions> allConditions() {
  std::vector<Conditions> all;
  for (const double loss : {0.0, 2.0, 10.0, 20.0})
    for (const double delay : {0.0, 50.0, 200.0})
      for (const double jitter : {0.0, 20.0, 100.0}) all.emplace_back(loss, delay, jitter);
  return all;
}

// The corners of the matrix that are hardest for each of the limits above.
const std::vector<Conditions> kCorners = {{0, 0, 0},     {0, 200, 100}, {2, 0, 100},    {2, 200, 0},
                                          {2, 200, 100}, {10, 0, 100},  {10, 200, 100}, {20, 200, 100}};

INSTANTIATE_TEST_SUITE_P(NetworkConditions, Matrix,
                         testing::ValuesIn(std::getenv("PLATON_LONG") != nullptr ? allConditions() : kCorners), nameOf);

}  // namespace
}  // namespace platon
