#include "client/play/offscreen/frame_benchmark.h"

#include <gtest/gtest.h>

#include "client/time/steady_now.h"
#include "server/app/level_files.h"

namespace platon::frame_benchmark_test {
namespace {

TEST(FrameBenchmark, MeasuresEveryQualityOnce) {
  const auto level = loadLevelFiles({shippedLevelFiles().front()}).levels.front();
  FrameBenchmark benchmark(level, {steadyClock().now, programTime, threadTime});
  const BenchmarkReport report = benchmark.run([] { return true; });
  EXPECT_FALSE(report.driver.empty());
  EXPECT_GT(report.frames, 0U);
  ASSERT_EQ(report.costs.size(), kQualities.size());
  for (std::size_t i = 0; i < report.costs.size(); ++i) {
    const FrameCost& cost = report.costs[i];
    EXPECT_EQ(cost.quality, kQualities[i].level);
    EXPECT_GT(cost.p50Ms, 0);
    EXPECT_LE(cost.p50Ms, cost.p99Ms);
    EXPECT_GT(cost.ownCpuMs, 0);
    EXPECT_GT(cost.allCpuMs, 0);
    EXPECT_GE(cost.drawCalls, BenchmarkGame::kPlayers);
  }
}

}  // namespace
}  // namespace platon::frame_benchmark_test
