#include "client/replay/run_store.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/protocol/work/held_threads.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::run_store_test {
namespace {

namespace fs = std::filesystem;

// A run to the goal on the right of the start, at a full run or slowly.
Run runOf(std::uint8_t speed = 0) {
  FollowedGame followed(
      levelOf("# title: Floor\nHEXAHEDRON\n0 0 -180 0\n0 100 -190\n480\n%\n-240 -200 240 "
              "-200\n%\n%\n%\n%\n%\n"));
  followed.hold(30, 0);
  followed.holdToGoal(300, static_cast<std::uint8_t>(Input::kRight | speed));
  return followed.run.value();
}

class RunStoreTest : public testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

  const TemporaryFolder folder_;
  const fs::path path_ = folder_ / "data/runs";
  RunStore store_{path_};
};

TEST_F(RunStoreTest, KeepsTheBestRunInOneFile) {
  const auto slow = runOf(Input::kWalk);
  const auto fast = runOf();
  ASSERT_LT(fast.ticks, slow.ticks);
  EXPECT_FALSE(store_.best(*slow.level));
  EXPECT_EQ(store_.keep(slow), "");
  EXPECT_EQ(store_.best(*slow.level)->ticks, slow.ticks);
  EXPECT_EQ(store_.keep(fast), "");
  EXPECT_EQ(files(), 1U);
  const StoredRun best = store_.best(*slow.level).value();
  EXPECT_EQ(best.ticks, fast.ticks);
  EXPECT_EQ(best.rules, kRulesVersion);
  EXPECT_EQ(readBytes(best.file), fast.recording);
}

TEST_F(RunStoreTest, OfTwoRunsOfALevelTheShorterCounts) {
  const auto slow = runOf(Input::kWalk);
  const auto fast = runOf();
  store_.keep(fast);
  store_.keep(slow);  // of another program that had read the folder before
  EXPECT_EQ(store_.best(*slow.level)->ticks, fast.ticks);
}

TEST_F(RunStoreTest, RunsOfOlderRulesAreKept) {
  const auto run = runOf();
  store_.keep(run);
  const std::string name = store_.best(*run.level)->file.filename().string();
  const std::string rules = "-" + std::to_string(kRulesVersion) + "-";
  std::string older = name;
  older.replace(older.find(rules), rules.size(), "-" + std::to_string(kRulesVersion - 1) + "-");
  older.replace(older.rfind('-'), std::string::npos, "-1.recording");
  const auto bytes = asOfOlderRules(run.recording, *run.level);
  writeText(path_ / older, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  store_.keep(run);
  EXPECT_EQ(store_.best(*run.level)->ticks, run.ticks) << "not that of older rules";
  EXPECT_EQ(files(), 2U);
  fs::last_write_time(path_ / older, fs::file_time_type::clock::now() - std::chrono::hours(48));
  const std::vector<StoredRun> runs = store_.all();
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_TRUE(store_.ownRunOf(runs[0].file));
  EXPECT_EQ(runs[1].rules, kRulesVersion - 1);
  EXPECT_EQ(runs[1].ticks, 1U);
  EXPECT_EQ(runs[1].bytes, bytes.size());
  EXPECT_FALSE(store_.ownRunOf(runs[1].file)) << "its rules are older";
}

TEST_F(RunStoreTest, OtherFilesAreLeftAlone) {
  store_.keep(runOf());
  for (const char* const name : {"notes", "1-7-5.recording", "0123456789abcdef-7-05.recording",
                                 "0123456789ABCDEF-7-5.recording", "0123456789abcdef-7-5.recordings"}) {
    writeText(path_ / name, "mine");
  }
  EXPECT_EQ(store_.all().size(), 1U);
  writeText(path_ / "0123456789abcdef-7-5.recording", "damaged");
  EXPECT_EQ(store_.all().size(), 2U) << "only the names count";
}

TEST_F(RunStoreTest, TheOldestOfTooManyIsRemoved) {
  const auto run = runOf();
  fs::create_directories(path_);
  for (std::size_t i = 0; i < RunStore::kMaxRuns; ++i) {
    std::string name = std::to_string(i);
    name.insert(0, 16 - name.size(), '0');
    name += "-7-5.recording";
    writeText(path_ / name, "x");
    fs::last_write_time(path_ / name, fs::file_time_type::clock::now() - std::chrono::hours(i + 1));
  }
  store_.keep(run);
  EXPECT_EQ(store_.all().size(), RunStore::kMaxRuns);
  EXPECT_TRUE(store_.best(*run.level));
  EXPECT_FALSE(fs::exists(path_ / "0000000000000511-7-5.recording"));
  EXPECT_TRUE(fs::exists(path_ / "0000000000000510-7-5.recording"));
}

TEST_F(RunStoreTest, TheBytesAreBounded) {
  const auto run = runOf();
  fs::create_directories(path_);
  for (int i = 0; i < 2; ++i) {
    const fs::path file = path_ / ("000000000000000" + std::to_string(i) + "-7-5.recording");
    writeText(file, "x");
    fs::resize_file(file, RunStore::kMaxBytes / 2);
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(i + 1));
  }
  store_.keep(run);
  EXPECT_EQ(store_.all().size(), 2U);
  auto large = run;
  large.recording.resize(RunStore::kMaxRunBytes + 1);
  EXPECT_EQ(store_.keep(large), "its recording is too large");
}

TEST_F(RunStoreTest, AServerCannotPushOutRunsOfOwnGamesNorOfOtherServers) {
  const auto run = runOf();
  const std::string name = RunStore::fileNameOf(run.level->hash, run.ticks);
  fs::create_directories(path_ / "servers/hostile");
  fs::create_directories(path_ / "servers/friend");
  const auto old = [&](const fs::path& file, std::size_t hours) {
    writeText(path_ / file, "x");
    fs::last_write_time(path_ / file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  old(RunStore::fileNameOf(1, 5), 9000);
  old("servers/friend/" + RunStore::fileNameOf(2, 5), 9000);
  for (std::uint64_t i = 0; i < RunStore::kMaxRuns; ++i)
    old("servers/hostile/" + RunStore::fileNameOf(1000 + i, 5), i + 1);
  RunStore hostile(path_, "hostile");
  EXPECT_EQ(hostile.keep(run), "");
  EXPECT_TRUE(fs::exists(path_ / "servers/hostile" / name));
  EXPECT_EQ(store_.all().size(), RunStore::kMaxServerRuns + 2);
  EXPECT_TRUE(fs::exists(path_ / RunStore::fileNameOf(1, 5)));
  EXPECT_TRUE(fs::exists(path_ / "servers/friend" / RunStore::fileNameOf(2, 5)));
  EXPECT_EQ(hostile.best(*run.level)->ticks, run.ticks);
}

TEST_F(RunStoreTest, ARunOnAServerIsTheBestOnlyThere) {
  const auto slow = runOf(Input::kWalk);
  const auto fast = runOf();
  RunStore server(path_, "server");
  server.keep(fast);
  EXPECT_FALSE(store_.best(*fast.level)) << "the server may have fed its inputs";
  store_.keep(slow);
  EXPECT_EQ(store_.best(*slow.level)->ticks, slow.ticks);
  EXPECT_EQ(server.best(*slow.level)->ticks, fast.ticks);
  EXPECT_EQ(RunStore(path_, "other").best(*slow.level)->ticks, slow.ticks);
  for (const StoredRun& run : store_.all())
    EXPECT_EQ(store_.ownRunOf(run.file).has_value(), run.file.parent_path() == path_);
}

TEST_F(RunStoreTest, ARunOnAnotherLevelWithTheSameHashIsNotTheBest) {
  const auto run = runOf();
  auto forged = std::make_shared<Level>(*run.level);
  forged->text += "# another";
  store_.keep(run);
  EXPECT_TRUE(store_.best(*run.level));
  EXPECT_FALSE(store_.best(*forged));
  ASSERT_TRUE(store_.bestByName(*forged)) << "nothing is read";
  EXPECT_EQ(store_.bestByName(*forged)->file, store_.fileOf(run));
}

TEST_F(RunStoreTest, ARunReplacesNoneOnAnotherLevelWithTheSameHash) {
  const auto slow = runOf(Input::kWalk);
  store_.keep(slow);
  auto other = runOf();
  auto forged = std::make_shared<Level>(*other.level);
  forged->text += "# another";
  other.level = forged;
  ASSERT_EQ(store_.keep(other), "");
  EXPECT_TRUE(fs::exists(store_.fileOf(slow)));
  EXPECT_EQ(files(), 2U);
}

TEST_F(RunStoreTest, ARunOnAServerReplacesNoneOfOwnGames) {
  store_.keep(runOf(Input::kWalk));
  RunStore server(path_, "server");
  server.keep(runOf());
  EXPECT_EQ(store_.all().size(), 2U);
}

TEST_F(RunStoreTest, TheServersOfLongAgoAreRemoved) {
  for (std::size_t i = 0; i < RunStore::kMaxServers; ++i) {
    const fs::path folder = path_ / "servers" / std::to_string(i);
    fs::create_directories(folder);
    writeText(folder / RunStore::fileNameOf(1, 5), "x");
    fs::last_write_time(folder / RunStore::fileNameOf(1, 5),
                        fs::file_time_type::clock::now() - std::chrono::hours(i + 1));
  }
  RunStore server(path_, "new");
  server.keep(runOf());
  EXPECT_TRUE(fs::exists(path_ / "servers/new"));
  EXPECT_TRUE(fs::exists(path_ / "servers" / std::to_string(RunStore::kMaxServers - 2)));
  EXPECT_FALSE(fs::exists(path_ / "servers" / std::to_string(RunStore::kMaxServers - 1)));
}

TEST_F(RunStoreTest, WithoutAFolderNothingIsKept) {
  RunStore none{fs::path()};
  EXPECT_EQ(none.keep(runOf()), "");
  EXPECT_TRUE(none.all().empty());
  EXPECT_TRUE(store_.all().empty());
}

TEST_F(RunStoreTest, AFailureNamesTheFile) {
  writeText(folder_ / "data", "a file");
  const std::string fault = store_.keep(runOf());
  EXPECT_EQ(fault.substr(0, path_.string().size()), path_.string());
  EXPECT_NE(fault.find(": Not a directory"), std::string::npos) << fault;
}

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
}  // namespace platon::run_store_test
