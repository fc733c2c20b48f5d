#include "client/replay/run_saver.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/client/replay/followed_game.h"
#include "tests/protocol/work/held_threads.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::run_saver_test {
namespace {

Run runTo(int x) {
  FollowedGame game(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 " + std::to_string(x) + " -190"));
  game.hold(30, 0);
  game.holdToGoal(300, Input::kRight);
  return game.run.value();
}

TEST(RunSaver, KeepsAllRuns) {
  const TemporaryFolder folder;
  RunSaver saver{RunStore(folder / "runs")};
  for (const int x : {80, 90, 100}) saver.keep(runTo(x));
  saver.finish();
  EXPECT_EQ(saver.store().all().size(), 3U);
  EXPECT_FALSE(saver.poll());
}

TEST(RunSaver, TheEndWaitsForTheDisk) {
  const TemporaryFolder folder;
  {
    RunSaver saver{RunStore(folder / "runs")};
    saver.keep(runTo(80));
    saver.keep(runTo(90));
  }
  EXPECT_EQ(RunStore(folder / "runs").all().size(), 2U);
}

TEST(RunSaver, AFailureIsReportedOnce) {
  const TemporaryFolder folder;
  writeText(folder / "runs", "a file");
  RunSaver saver{RunStore(folder / "runs")};
  saver.keep(runTo(80));
  saver.finish();
  const std::optional<std::string> fault = saver.poll();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->find((folder / "runs").string()), 0U) << *fault;
  EXPECT_FALSE(saver.poll());
}

TEST(RunSaver, KnowsTheLastRunOnALevelThatIsNotWritten) {
  const TemporaryFolder folder;
  HeldThreads threads;
  threads.hold();
  const platon::Run other = runTo(80);
  const platon::Run first = runTo(90);
  const Level level = *first.level;
  platon::Run second = first;
  second.ticks -= 1;
  RunSaver saver(RunStore(folder / "runs"), threads.start());
  EXPECT_FALSE(saver.isPending());
  for (const platon::Run& run : {first, second, other}) saver.keep(run);
  EXPECT_TRUE(saver.isPending());
  ASSERT_NE(saver.unsavedOn(level), nullptr);
  EXPECT_EQ(saver.unsavedOn(level)->ticks, second.ticks);
  threads.letGo();
  saver.finish();
  EXPECT_FALSE(saver.isPending());
  EXPECT_EQ(saver.unsavedOn(level), nullptr);
  EXPECT_TRUE(std::filesystem::exists(saver.store().fileOf(second)));
}

}  // namespace
}  // namespace platon::run_saver_test
