#include "client/editor/level_analysis.h"

#include <gtest/gtest.h>

#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "tests/client/editor/test_editor.h"
#include "tests/support/files.h"
#include "tests/support/wait_until.h"

namespace platon::level_analysis_test {
namespace {

using Way = LevelReport::Way;

std::shared_ptr<const Level> levelWith(const std::string& segments) {
  return loadLevel(TestEditor::levelText(segments)).level;
}

// The last report: that of the finished search.
LevelReport resultOf(LevelAnalysis& analysis) {
  LevelReport last;
  EXPECT_TRUE(stepUntil([&] { std::this_thread::yield(); },
                        [&] {
                          std::optional<LevelReport> report = analysis.take();
                          if (report) last = std::move(*report);
                          return last.finished;
                        }));
  return last;
}

TEST(LevelAnalysisTest, AWayIsFound) {
  LevelAnalysis analysis;
  const auto level = levelWith("");
  analysis.start(level);
  const LevelReport report = resultOf(analysis);
  EXPECT_EQ(report.way, Way::kFound);
  EXPECT_EQ(report.level, level);
  EXPECT_EQ(report.facts.presses, 1U);
  ASSERT_TRUE(report.reached);
  EXPECT_FALSE(report.reached->empty());
  ASSERT_EQ(report.paths.size(), 1U);
  EXPECT_GT(report.paths[0].size(), 5U);
}

TEST(LevelAnalysisTest, AGoalInABoxIsProvedToBeOutOfReach) {
  LevelAnalysis analysis;
  analysis.start(levelWith("60 -200 60 -140\n60 -140 140 -140\n140 -140 140 -200\n"));
  const LevelReport report = resultOf(analysis);
  EXPECT_EQ(report.way, Way::kImpossible);
  for (const FacePlace& place : *report.reached)
    EXPECT_FALSE(place.face == 0 && place.place.x > 66 && place.place.x < 134 && place.place.y < -146 &&
                 place.place.y > -194);
}

TEST(LevelAnalysisTest, OnlyTheNewestLevelIsReported) {
  LevelAnalysis analysis;
  const auto hard = loadLevel(readText("tests/determinism/golden/levels/dodecahedron.level")).level;
  const auto easy = levelWith("");
  for (int i = 0; i < 20; ++i) {
    analysis.start(hard);
    std::this_thread::yield();
    analysis.start(easy);
  }
  EXPECT_EQ(resultOf(analysis).level, easy);
}

// Time of the processor that this program has used, which does not depend on what else the machine does.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The whole analysis of this level takes many seconds.
TEST(LevelAnalysisTest, AnAnalysisIsGivenUpAtOnce) {
  std::optional<LevelAnalysis> analysis(std::in_place);
  analysis->start(loadLevel(readText("tests/determinism/golden/levels/dodecahedron.level")).level);
  ASSERT_TRUE(waitUntil([&] { return analysis->take().has_value(); }));
  const double before = processorSeconds();
  analysis.reset();
  EXPECT_LT(processorSeconds() - before, 3);
}

}  // namespace
}  // namespace platon::level_analysis_test
