#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

#include "tests/net/support/pressing.h"
#include "tests/net/support/session_network.h"
#include "tests/support/test_levels.h"

namespace platon::system_matrix_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 20261122;
constexpr std::size_t kPlayers = 16;
constexpr Time kSettling = seconds(10);
constexpr Time kMeasured = seconds(12);

// Totals of all players.
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

Counts countsOf(const SessionNetwork& match) {
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
  static LinkQuality quality() {
    LinkQuality quality;
    std::tie(quality.lossPercent, quality.delayMs, quality.jitterMs) = GetParam();
    return quality;
  }

  static double percent(double part, double whole) { return 100 * part / whole; }

  // Ticks by which a client may be behind the server: delay, jitter, the server's pause between messages, and the
  // messages after a lost one until one arrives.
  static double maxTicksBehind() {
    const double transitMs = quality().delayMs + quality().jitterMs;
    return transitMs * kTicksPerSecond / 1000 + 2 + (quality().lossPercent > 0 ? 10 : 0);
  }

  static void expectInLockstep(SessionNetwork& match) {
    for (std::size_t player = 0; player < kPlayers; ++player) {
      const Round* const round = match.session(player).round();
      ASSERT_NE(round, nullptr);
      EXPECT_EQ(round->id(), match.match().round());
      EXPECT_TRUE(round->prediction().present());
      EXPECT_GE(round->prediction().confirmedTicks() + maxTicksBehind(), match.match().game().tick()) << player;
    }
  }
};

// Sixteen players under these conditions. SessionNetwork checks at every update that each confirmed game equals the
// server's.
TEST_P(Matrix, InputsArriveInTimeAndGamesStayInLockstep) {
  SessionNetwork match({endlessLevel()}, kSeed);
  for (std::size_t player = 0; player < kPlayers; ++player) {
    match.join(quality(), pressing(kSeed + player));
    match.run(milliseconds(60));
  }
  match.run(kSettling);
  const Counts before = countsOf(match);
  match.run(kMeasured);
  const Counts all = countsOf(match);
  const Counts counts = all - before;
  expectInLockstep(match);
  EXPECT_EQ(all.desyncs, 0u);
  EXPECT_EQ(all.resyncs, 0u);
  EXPECT_GT(counts.confirmed, kPlayers * (toSeconds(kMeasured) * kTicksPerSecond - maxTicksBehind()));
  if (quality().lossPercent <= 10) {
    EXPECT_LT(percent(counts.missed, counts.confirmed), 0.1);
  }
  if (quality().lossPercent <= 2) {
    EXPECT_LT(percent(counts.mispredicted, counts.confirmed), 0.5);
  }
  std::printf("loss %g %%, delay %g ms, jitter %g ms: missed %.4f %%, mispredicted %.4f %% (seed %llu)\n",
              quality().lossPercent, quality().delayMs, quality().jitterMs, percent(counts.missed, counts.confirmed),
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

// The corners of the matrix: the perfect connection, and the hardest one for each of the limits above.
const std::vector<Conditions> kCorners = {{0, 0, 0}, {2, 200, 100}, {10, 200, 100}, {20, 200, 100}};

INSTANTIATE_TEST_SUITE_P(NetworkConditions, Matrix,
                         testing::ValuesIn(std::getenv("PLATON_LONG") != nullptr ? allConditions() : kCorners), nameOf);

}  // namespace
}  // namespace platon::system_matrix_test
