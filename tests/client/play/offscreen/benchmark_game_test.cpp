#include "client/play/offscreen/benchmark_game.h"

#include <set>

#include <gtest/gtest.h>

#include "server/app/level_files.h"

namespace platon::benchmark_game_test {
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

}  // namespace
}  // namespace platon::benchmark_game_test
