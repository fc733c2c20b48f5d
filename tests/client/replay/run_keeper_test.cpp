#include "client/replay/run_keeper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "client/ui/player_rows.h"
#include "tests/client/replay/crowded_door_level.h"
#include "tests/client/replay/replay_of.h"
#include "tests/protocol/work/held_threads.h"
#include "tests/protocol/work/no_thread.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::run_keeper_test {
namespace {

// Over an edge to the goal on the next face.
std::shared_ptr<const Level> edgeLevel(const std::string& goal = "1 0 -190") {
  return cubeLevel("0 0 -180 0", {"-240 -200 240 -200", "-240 -200 240 -200"}, goal);
}

// Without threads all is read and written at once.
class RunKeeperTest : public testing::Test {
 protected:
  explicit RunKeeperTest(bool threads = false)
      : keeper_(RunStore(folder_ / "runs"), folder_ / "ghosts", {},
                threads ? threads_.start() : ThreadStart(noThread)) {}

  void begin() { keeper_.began(game_, 0); }
  void hold(int ticks, std::uint8_t buttons) {
    const std::vector<Input> inputs{{static_cast<std::uint8_t>(buttons | Input::kPresent)}};
    for (int i = 0; i < ticks; ++i) {
      game_.advance(inputs);
      keeper_.advanced(inputs, game_);
    }
  }
  // An attempt after R: waits, runs to the goal with this speed. Returns its time.
  std::uint32_t attempt(int wait, std::uint8_t speed) {
    hold(1, Input::kRestart);
    hold(wait, 0);
    for (int i = 0; i < 1000 && game_.player(0).arrived == 0; ++i) {
      hold(1, static_cast<std::uint8_t>(Input::kRight | speed));
    }
    return game_.tick() - game_.player(0).startedAt + 1;
  }
  double seconds(std::int64_t ticks) const { return static_cast<double>(ticks) / kTicksPerSecond; }

  const TemporaryFolder folder_;
  Game game_{edgeLevel()};
  HeldThreads threads_;
  RunKeeper keeper_;
};

TEST_F(RunKeeperTest, TheFirstRunIsTheBestAndIsKept) {
  begin();
  EXPECT_FALSE(keeper_.status().best);
  const std::uint32_t ticks = attempt(40, 0);
  EXPECT_TRUE(keeper_.status().isNewBest);
  EXPECT_EQ(keeper_.status().best, seconds(ticks));
  EXPECT_FALSE(keeper_.status().difference) << "there was none before";
  ASSERT_TRUE(keeper_.store().best(game_.level()));
  EXPECT_EQ(keeper_.store().best(game_.level())->ticks, ticks);
  RunKeeper next(RunStore(folder_ / "runs"), {}, {}, noThread);
  next.began(Game(edgeLevel()), 0);
  EXPECT_EQ(next.status().best, seconds(ticks));
}

// Reaches the goal with the help of others, in a game that nobody could read again. Of the attempt the keeper sees all,
// or not its first tick.
void reachWithManyOthers(RunKeeper& keeper, Game& game, std::vector<Input>& inputs, bool fromTheBeginning) {
  const auto hold = [&](int ticks, std::uint8_t helper, std::uint8_t own) {
    inputs[0].buttons = static_cast<std::uint8_t>(helper | Input::kPresent);
    inputs[1].buttons = static_cast<std::uint8_t>(own | Input::kPresent);
    for (int i = 0; i < ticks && (game.slots() == 0 || game.player(1).arrived == 0); ++i) {
      game.advance(inputs);
      keeper.advanced(inputs, game);
    }
  };
  if (!fromTheBeginning) {
    inputs[1].buttons = Input::kPresent | Input::kRight;
    game.advance(inputs);
  }
  keeper.began(game, 1);
  hold(100, 0, 0);
  hold(2500, Input::kLeft, 0);
  hold(300, 0, Input::kRight);
  ASSERT_EQ(game.player(1).arrived, 1);
}

TEST_F(RunKeeperTest, ARunThatCostsTooMuchToBeRecordedSaysSo) {
  Game game(crowdedDoorLevel());
  std::vector<Input> inputs(kMaxPlayers);
  reachWithManyOthers(keeper_, game, inputs, true);
  EXPECT_EQ(keeper_.status().notRecorded, "too many players to be recorded");
  EXPECT_FALSE(keeper_.status().isNewBest);
  inputs[1].buttons = Input::kPresent | Input::kRestart;
  game.advance(inputs);
  keeper_.advanced(inputs, game);
  EXPECT_EQ(keeper_.status().notRecorded, "");
}

// The number of players was blamed.
TEST_F(RunKeeperTest, ARunWhoseBeginningIsUnknownIsNotRecordedForAnotherReasonThanItsPlayers) {
  Game game(crowdedDoorLevel());
  std::vector<Input> inputs(kMaxPlayers);
  reachWithManyOthers(keeper_, game, inputs, false);
  EXPECT_FALSE(keeper_.status().isNewBest);
  EXPECT_EQ(keeper_.status().notRecorded, "");
}

TEST_F(RunKeeperTest, ASlowerRunIsNotKept) {
  begin();
  const std::uint32_t best = attempt(40, 0);
  const std::uint32_t slow = attempt(40, Input::kWalk);
  ASSERT_GT(slow, best);
  EXPECT_FALSE(keeper_.status().isNewBest);
  EXPECT_EQ(keeper_.status().best, seconds(best));
  EXPECT_EQ(keeper_.status().difference, seconds(std::int64_t{slow} - best));
  EXPECT_EQ(keeper_.store().best(game_.level())->ticks, best);
  hold(1, Input::kRestart);
  EXPECT_FALSE(keeper_.status().difference);
}

TEST_F(RunKeeperTest, AFasterRunReplacesIt) {
  begin();
  const std::uint32_t slow = attempt(40, Input::kWalk);
  const std::uint32_t fast = attempt(40, 0);
  EXPECT_TRUE(keeper_.status().isNewBest);
  EXPECT_EQ(keeper_.status().best, seconds(fast));
  EXPECT_EQ(keeper_.status().difference, seconds(std::int64_t{fast} - slow));
  EXPECT_EQ(keeper_.store().all().size(), 1U);
}

TEST_F(RunKeeperTest, TheDifferenceAtASplitIsShownForTwoSeconds) {
  begin();
  attempt(40, 0);
  const auto best = trackOf(*replayOf(readBytes(keeper_.store().best(game_.level())->file)));
  ASSERT_TRUE(best);
  ASSERT_EQ(best->splits.size(), 1U);
  hold(1, Input::kRestart);
  hold(40, 0);
  while (game_.world().entities()[0].part == 0) hold(1, Input::kRight | Input::kWalk);
  const std::int64_t ticks = std::int64_t{game_.tick()} - game_.player(0).startedAt + 1;
  ASSERT_TRUE(keeper_.status().difference);
  EXPECT_EQ(*keeper_.status().difference, seconds(ticks - best->splits[0].ticks));
  EXPECT_GT(*keeper_.status().difference, 0);
  hold(RunKeeper::kShownTicks - 1, 0);
  EXPECT_TRUE(keeper_.status().difference);
  hold(1, 0);
  EXPECT_FALSE(keeper_.status().difference);
}

TEST_F(RunKeeperTest, TheGhostRunsInTimeWithTheAttempt) {
  begin();
  EXPECT_TRUE(keeper_.ghostsAt(game_, 0, 1).empty());
  attempt(40, 0);
  const auto best = trackOf(*replayOf(readBytes(keeper_.store().best(game_.level())->file)));
  hold(1, Input::kRestart);
  hold(77, 0);
  EXPECT_TRUE(keeper_.ghostsAt(game_, 0, 1).empty()) << "waits for the first input";
  for (std::uint32_t ticks = 1; ticks <= best->ticks + 20; ++ticks) {
    hold(1, ticks == 1 ? Input::kLeft : 0);
    const auto ghosts = keeper_.ghostsAt(game_, 0, 0.5);
    ASSERT_EQ(ghosts.size(), 1U);
    ASSERT_EQ(ghosts[0].player.now.position, best->places[std::min(ticks, best->ticks)].position) << ticks;
    ASSERT_EQ(ghosts[0].player.fraction, 0.5);
  }
}

TEST_F(RunKeeperTest, TheGhostOfAnAttemptStaysThatOfItsBeginning) {
  begin();
  const std::uint32_t slow = attempt(40, Input::kWalk);
  const std::uint32_t fast = attempt(40, 0);
  const auto ghosts = keeper_.ghostsAt(game_, 0, 1);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_NE(ghosts[0].player.now.position, game_.world().entities()[0].position)
      << "the slower run is still on its way";
  EXPECT_LT(fast, slow);
}

TEST_F(RunKeeperTest, OthersAreGhostsToo) {
  begin();
  attempt(40, 0);
  const auto best = keeper_.store().best(game_.level())->file;
  std::filesystem::create_directories(folder_ / "ghosts");
  for (const char* const name : {"a", "b", "c", "d"}) std::filesystem::copy_file(best, folder_ / "ghosts" / name);
  RunKeeper next(RunStore(folder_ / "runs"), folder_ / "ghosts", {}, noThread);
  Game game(edgeLevel());
  next.began(game, 0);
  const std::vector<Input> right{{Input::kPresent | Input::kRight}};
  game.advance(right);
  next.advanced(right, game);
  const auto ghosts = next.ghostsAt(game, 0, 1);
  ASSERT_EQ(ghosts.size(), 1 + RunKeeper::kMaxOthers);
  EXPECT_EQ(ghosts[0].name.substr(0, 5), "best ");
  EXPECT_EQ(ghosts[3].name, "c");
}

TEST_F(RunKeeperTest, TheRivalIsAGhostOnceOnItsLevel) {
  begin();
  attempt(40, 0);
  const std::filesystem::path best = keeper_.store().best(game_.level())->file;
  std::filesystem::copy_file(best, folder_ / "Anna.recording");
  const auto ghostsWith = [&](const std::filesystem::path& rival) {
    RunKeeper next(RunStore(folder_ / "runs"), {}, rival, noThread);
    Game game(edgeLevel());
    next.began(game, 0);
    const std::vector<Input> right{{Input::kPresent | Input::kRight}};
    game.advance(right);
    next.advanced(right, game);
    EXPECT_TRUE(next.takeFaults().empty());
    return next.ghostsAt(game, 0, 1);
  };
  EXPECT_EQ(ghostsWith(best).size(), 1U) << "the best run is one already";
  ASSERT_EQ(ghostsWith(folder_ / "Anna.recording").size(), 2U);
  EXPECT_EQ(ghostsWith(folder_ / "Anna.recording")[1].name, "Anna");
  EXPECT_EQ(ghostsWith(folder_ / "missing").size(), 1U);
}

TEST_F(RunKeeperTest, AnotherLevelHasAnotherBestRun) {
  begin();
  attempt(40, 0);
  const Game other(edgeLevel("1 100 -190"));
  keeper_.began(other, 0);
  EXPECT_FALSE(keeper_.status().best);
  EXPECT_TRUE(keeper_.ghostsAt(game_, 0, 1).empty()) << "of the level before";
  keeper_.began(Game(edgeLevel()), 0);
  EXPECT_TRUE(keeper_.status().best);
}

TEST_F(RunKeeperTest, ADamagedBestRunIsNamedAndDoesNotCount) {
  begin();
  attempt(40, 0);
  const std::filesystem::path file = keeper_.store().best(game_.level())->file;
  writeText(file, "damaged");
  RunKeeper next(RunStore(folder_ / "runs"), {}, {}, noThread);
  next.began(Game(edgeLevel()), 0);
  EXPECT_FALSE(next.status().best);
  const std::vector<std::string> faults = next.takeFaults();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].substr(0, file.string().size()), file.string());
  EXPECT_TRUE(next.takeFaults().empty());
}

// It had the best time, by its name, so that any other one was a new best.
TEST_F(RunKeeperTest, AFileThatIsNoRunHidesNoneThatIsSlower) {
  begin();
  const std::uint32_t best = attempt(40, 0);
  const std::filesystem::path file = keeper_.store().best(game_.level())->file;
  writeText(folder_ / "runs" / RunStore::fileNameOf(game_.level().hash, 6), "damaged");
  keeper_.began(Game(edgeLevel("1 0 -189")), 0);
  game_ = Game(edgeLevel());
  begin();
  EXPECT_EQ(keeper_.status().best, seconds(best));
  EXPECT_EQ(keeper_.bestFile(), file);
  ASSERT_GT(attempt(40, Input::kWalk), best);
  EXPECT_FALSE(keeper_.status().isNewBest);
}

TEST_F(RunKeeperTest, AnAttemptInWhichRunsDidNotCountForAWhileIsNotKept) {
  begin();
  hold(1, Input::kRestart);
  hold(20, Input::kRight);
  keeper_.countRuns(false);
  keeper_.countRuns(true);
  for (int i = 0; i < 1000 && game_.player(0).arrived == 0; ++i) hold(1, Input::kRight);
  ASSERT_NE(game_.player(0).arrived, 0);
  EXPECT_FALSE(keeper_.status().isNewBest);
  EXPECT_FALSE(keeper_.store().best(game_.level()));
  attempt(40, Input::kWalk);
  EXPECT_TRUE(keeper_.status().isNewBest) << "an attempt begun when runs count again";
  EXPECT_TRUE(keeper_.store().best(game_.level()));
}

TEST_F(RunKeeperTest, ALevelWithTheHashOfAnotherHasNoneOfItsRuns) {
  begin();
  attempt(40, 0);
  ASSERT_TRUE(keeper_.store().best(game_.level()));
  auto forged = std::make_shared<Level>(*edgeLevel("1 100 -190"));
  forged->hash = game_.level().hash;
  std::filesystem::create_directories(folder_ / "ghosts");
  std::filesystem::copy_file(keeper_.store().best(game_.level())->file, folder_ / "ghosts/Anna.recording");
  RunKeeper next(RunStore(folder_ / "runs"), folder_ / "ghosts", folder_ / "ghosts/Anna.recording", noThread);
  Game game(forged);
  next.began(game, 0);
  EXPECT_FALSE(next.status().best);
  const std::vector<Input> right{{Input::kPresent | Input::kRight}};
  game.advance(right);
  next.advanced(right, game);
  EXPECT_TRUE(next.ghostsAt(game, 0, 1).empty());
}

// With threads that work only when the test lets them go.
class HeldRunKeeperTest : public RunKeeperTest {
 protected:
  HeldRunKeeperTest() : RunKeeperTest(true) {}
  ~HeldRunKeeperTest() override { threads_.letGo(); }

  // A restart and the first tick of the attempt. Returns the names of the ghosts in it.
  std::vector<std::string> start() {
    hold(1, Input::kRestart);
    hold(1, Input::kRight);
    return ghosts();
  }
  std::vector<std::string> ghosts() const {
    std::vector<std::string> names;
    for (const GhostSource& ghost : keeper_.ghostsAt(game_, 0, 1)) names.push_back(ghost.name);
    return names;
  }
  std::vector<std::string> bestGhost(std::uint32_t ticks) const { return {"best " + finishText(seconds(ticks))}; }
  std::filesystem::path fileOf(std::uint32_t ticks) const {
    return folder_ / "runs" / RunStore::fileNameOf(game_.level().hash, ticks);
  }
  // Whether this becomes the file of the best run.
  bool waitForFile(std::uint32_t ticks) {
    return waitUntil([&] {
      EXPECT_TRUE(keeper_.takeFaults().empty());
      return keeper_.bestFile() == fileOf(ticks);
    });
  }
  // Runs to the goal with this speed. Returns the time.
  static std::uint32_t finish(RunKeeper& keeper, Game& game, std::uint8_t speed) {
    const auto right = static_cast<std::uint8_t>(Input::kPresent | Input::kRight | speed);
    for (int i = 0; i < 1000 && (i == 0 || game.player(0).arrived == 0); ++i) {
      const std::vector<Input> inputs{{i < 40 ? std::uint8_t{Input::kPresent} : right}};
      game.advance(inputs);
      keeper.advanced(inputs, game);
    }
    return game.player(0).finishTicks;
  }
  // Keeps a run in which the player walks. Returns its time.
  std::uint32_t keepSlowRun() {
    RunKeeper other(RunStore(folder_ / "runs"), {}, {}, noThread);
    Game game(edgeLevel());
    other.began(game, 0);
    return finish(other, game, Input::kWalk);
  }
};

TEST_F(HeldRunKeeperTest, TheGameGoesOnWhileTheBestRunIsRead) {
  const std::uint32_t slow = keepSlowRun();
  threads_.hold();
  begin();
  EXPECT_EQ(keeper_.status().best, seconds(slow)) << "its file tells it";
  EXPECT_TRUE(waitForFile(slow));
  EXPECT_TRUE(start().empty());
  threads_.letGo();
  EXPECT_TRUE(waitUntil([&] {
    hold(1, 0);
    return ghosts() == bestGhost(slow);
  })) << "also in an attempt that has begun before";
}

TEST_F(HeldRunKeeperTest, AGoalIsComparedWithTheBestRunThatIsStillBeingRead) {
  const std::uint32_t slow = keepSlowRun();
  threads_.hold();
  begin();
  hold(40, 0);
  const auto isNext = [&] {
    Game next = game_;
    next.advance(std::vector<Input>{{Input::kPresent | Input::kRight}});
    return next.player(0).arrived != 0;
  };
  for (int i = 0; i < 1000 && !isNext(); ++i) hold(1, Input::kRight);
  threads_.letGo();
  hold(1, Input::kRight);
  const std::uint32_t fast = game_.player(0).finishTicks;
  EXPECT_EQ(keeper_.status().difference, seconds(std::int64_t{fast} - slow));
  EXPECT_TRUE(keeper_.status().isNewBest);
}

TEST_F(HeldRunKeeperTest, AGoalDoesNotWaitForTheGhostsOfOthers) {
  const std::uint32_t slow = keepSlowRun();
  std::filesystem::copy(folder_ / "runs", folder_ / "ghosts");
  threads_.hold();
  RunKeeper keeper(RunStore(folder_ / "runs"), folder_ / "ghosts", {}, [this, begun = 0](auto work) mutable {
    return ++begun == 1 ? startThread(std::move(work)) : threads_.start()(std::move(work));
  });
  keeper.began(game_, 0);
  const std::uint32_t fast = finish(keeper, game_, 0);
  EXPECT_EQ(keeper.status().difference, seconds(std::int64_t{fast} - slow));
  EXPECT_EQ(keeper.ghostsAt(game_, 0, 1).size(), 1U) << "that of another is not read yet";
  threads_.letGo();
}

TEST_F(HeldRunKeeperTest, ARestartAtTheGoalDoesNotWaitForTheNewBestRun) {
  const std::uint32_t slow = keepSlowRun();
  begin();
  ASSERT_TRUE(waitUntil([&] { return start() == bestGhost(slow); }));
  threads_.hold();
  const std::uint32_t fast = attempt(40, 0);
  EXPECT_TRUE(keeper_.status().isNewBest);
  EXPECT_EQ(start(), bestGhost(slow));
  EXPECT_EQ(keeper_.status().best, seconds(fast));
  EXPECT_TRUE(waitForFile(slow)) << "the faster one is still being written";
  threads_.letGo();
  EXPECT_TRUE(waitUntil([&] { return start() == bestGhost(fast); }));
  EXPECT_TRUE(waitForFile(fast));
}

TEST_F(HeldRunKeeperTest, ALevelThatComesBackHasTheBestRunThatIsStillBeingWritten) {
  const std::uint32_t slow = keepSlowRun();
  begin();
  ASSERT_TRUE(waitUntil([&] { return start() == bestGhost(slow); }));
  threads_.hold();
  const std::uint32_t fast = attempt(40, 0);
  keeper_.began(Game(edgeLevel("1 100 -190")), 0);
  EXPECT_FALSE(keeper_.status().best);
  EXPECT_EQ(keeper_.bestFile(), std::filesystem::path());
  begin();
  EXPECT_EQ(keeper_.status().best, seconds(fast));
  threads_.letGo();
  EXPECT_TRUE(waitUntil([&] { return start() == bestGhost(fast); }));
  EXPECT_TRUE(waitForFile(fast));
}

// The test does the work of the threads, in an order of its own: the old file is found, replaced, and only then told.
TEST_F(HeldRunKeeperTest, TheFileThatIsWrittenWhileTheLevelIsReadRemainsTheBest) {
  const std::uint32_t slow = keepSlowRun();
  bool waits = false;
  std::vector<std::function<void()>> works;
  RunKeeper keeper(RunStore(folder_ / "runs"), {}, {}, [&](std::function<void()> run) {
    waits ? works.push_back(std::move(run)) : run();
    return std::thread();
  });
  Game game(edgeLevel());
  keeper.began(game, 0);
  EXPECT_EQ(keeper.bestFile(), fileOf(slow));
  waits = true;
  const std::uint32_t fast = finish(keeper, game, 0);
  ASSERT_EQ(works.size(), 2U) << "the track of the new run, and its file";
  const auto writeFile = works[1];
  keeper.began(Game(edgeLevel("1 100 -190")), 0);
  Game again(edgeLevel());
  keeper.began(again, 0);
  ASSERT_EQ(works.size(), 3U) << "a level is read";
  works[2]();
  writeFile();
  EXPECT_FALSE(std::filesystem::exists(fileOf(slow)));
  EXPECT_TRUE(keeper.takeFaults().empty());
  EXPECT_EQ(keeper.bestFile(), fileOf(fast));
  const std::vector<Input> right{{Input::kPresent | Input::kRight}};
  again.advance(right);
  keeper.advanced(right, again);
  EXPECT_EQ(keeper.ghostsAt(again, 0, 1).size(), 1U) << "what was read is taken";
  EXPECT_EQ(keeper.bestFile(), fileOf(fast));
}

}  // namespace
}  // namespace platon::run_keeper_test
