#include "client/play/offscreen/frame_benchmark.h"

#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "client/time/steady_now.h"
#include "server/app/level_files.h"

namespace platon::frame_benchmark_test {
namespace {

std::shared_ptr<const Level> firstLevel() { return loadLevelFiles({shippedLevelFiles().front()}).levels.front(); }

TEST(BenchmarkGame, SixteenPlayersMoveAndTheCameraCrossesEdges) {
  BenchmarkGame game(firstLevel());
  std::set<int> faces;
  for (int turn = 0; turn < 60; ++turn) {
    game.advance(10);
    const Scene scene = game.scene();
    ASSERT_EQ(scene.players.size(), BenchmarkGame::kPlayers);
    EXPECT_TRUE(scene.players.back().local);
    faces.insert(scene.stage->mesh.faceTowards(scene.focus.position));
  }
  EXPECT_GE(faces.size(), 2U);
  std::set<double> places;
  for (const PlayerDrawing& player : game.scene().players) places.insert(player.pose.position.x);
  EXPECT_GE(places.size(), 2U) << "they follow each other";
}

TEST(BenchmarkGame, IsTheSameEachTime) {
  BenchmarkGame one(firstLevel());
  BenchmarkGame other(firstLevel());
  one.advance(300);
  for (int turn = 0; turn < 30; ++turn) other.advance(10);
  for (std::size_t i = 0; i < BenchmarkGame::kPlayers; ++i)
    EXPECT_EQ(one.scene().players[i].pose.position, other.scene().players[i].pose.position);
}

TEST(BenchmarkGame, BeginsAnewWhenAllHaveReachedTheGoal) {
  BenchmarkGame game(firstLevel());
  double latest = 0;
  bool again = false;
  for (int turn = 0; turn < 200 && !again; ++turn) {
    game.advance(30);
    again = game.scene().seconds < latest;
    latest = game.scene().seconds;
  }
  EXPECT_TRUE(again);
}

TEST(BenchmarkGame, PredictsAsAClientDoes) {
  BenchmarkGame game(firstLevel());
  constexpr std::uint32_t kTicks = 240;
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    game.advance(1);
    game.predict();
    game.predict();  // nothing is left to do
  }
  const Prediction& prediction = game.prediction();
  EXPECT_EQ(prediction.predictedTicks(), kTicks);
  EXPECT_EQ(prediction.confirmedTicks(), kTicks - BenchmarkGame::kLead);
  EXPECT_EQ(prediction.held().size(), BenchmarkGame::kPlayers);
  EXPECT_EQ(prediction.statistics().missedInputs, 0U);
  EXPECT_EQ(prediction.statistics().corrections, 0U);
  EXPECT_GT(prediction.work(), std::uint64_t{2 * kTicks - BenchmarkGame::kLead} * BenchmarkGame::kPlayers)
      << "ticks are replayed";
}

TEST(FrameBenchmark, MeasuresEveryQualityOnce) {
  FrameBenchmark benchmark(firstLevel(), {steadyClock().now, programTime, threadTime});
  benchmark.measure();
  EXPECT_FALSE(benchmark.done());
  const BenchmarkReport report = benchmark.report();
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
