#include "server/times/best_time_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "platon/game/game.h"
#include "protocol/files/private_file.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::best_time_store_test {
namespace {

using namespace std::chrono_literals;

const UtcTime kDate = *parseUtcTime("2026-12-01T18:00:00Z");
constexpr FileWriter::Time kNow{1h};

UtcTime clockOf() { return kDate; }

BestTimes timesIn(const std::string& path) {
  auto read = readBestTimes(path);
  const auto* errors = std::get_if<std::vector<std::string>>(&read);
  EXPECT_EQ(errors, nullptr) << errors->front();
  return errors ? BestTimes() : std::get<BestTimes>(std::move(read));
}

class BestTimeStoreTest : public testing::Test {
 protected:
  BestTimeStore open() { return {clockOf, path_, timesIn(path_)}; }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "best_times";
};

TEST_F(BestTimeStoreTest, WithoutAFileTimesEndWithTheStore) {
  BestTimeStore store(clockOf);
  EXPECT_EQ(store.best(5), std::nullopt);
  EXPECT_TRUE(store.offer(5, {100, "Ann"}));
  EXPECT_FALSE(store.offer(5, {100, "Ben"}));
  EXPECT_EQ(store.best(5), (BestTime{100, "Ann"}));
  EXPECT_EQ(store.poll(kNow), std::nullopt);
  EXPECT_EQ(store.finish(), std::nullopt);
}

TEST_F(BestTimeStoreTest, ATimeThatEndsWithTheServerIsNotInTheFileNorHidesOneThatLasts) {
  {
    BestTimeStore store = open();
    EXPECT_TRUE(store.offer(5, {100, "Ben"}, false));
    EXPECT_FALSE(store.pending());
    EXPECT_FALSE(store.offer(5, {110, "Ann"}, true));
    EXPECT_EQ(store.best(5), (BestTime{100, "Ben"}));
    EXPECT_EQ(store.finish(), std::nullopt);
  }
  EXPECT_EQ(open().best(5), (BestTime{110, "Ann"}));
}

TEST_F(BestTimeStoreTest, AFileKeepsTheTimesForTheNextStart) {
  {
    BestTimeStore store = open();
    EXPECT_TRUE(store.offer(5, {100, "Ann"}));
    EXPECT_TRUE(store.offer(6, {90, "Ben"}));
    EXPECT_TRUE(store.pending());
    EXPECT_EQ(store.finish(), std::nullopt);
    EXPECT_FALSE(store.pending());
  }
  BestTimeStore store = open();
  EXPECT_EQ(store.best(5), (BestTime{100, "Ann"}));
  EXPECT_EQ(store.best(6), (BestTime{90, "Ben"}));
  EXPECT_EQ(timesIn(path_).find({5, kRulesVersion})->date, kDate);
}

TEST_F(BestTimeStoreTest, TimesOfOtherRulesStayInTheFileAndDoNotCount) {
  const std::string other = "0000000000000005 4294967295 1 2026-01-01T00:00:00Z Cid\n";
  writeText(path_, other);
  BestTimeStore store = open();
  EXPECT_EQ(store.best(5), std::nullopt);
  EXPECT_TRUE(store.offer(5, {100, "Ann"}));
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_NE(readText(path_).find(other), std::string::npos);
  EXPECT_EQ(timesIn(path_).size(), 2u);
}

TEST_F(BestTimeStoreTest, TwoServersShareAFile) {
  BestTimeStore a = open();
  BestTimeStore b = open();
  a.offer(1, {10, "a"});
  a.offer(2, {10, "a"});
  EXPECT_EQ(a.finish(), std::nullopt);
  b.offer(2, {9, "b"});
  b.offer(3, {9, "b"});
  EXPECT_EQ(b.finish(), std::nullopt);
  a.offer(3, {8, "a"});
  EXPECT_EQ(a.finish(), std::nullopt);
  const BestTimes times = timesIn(path_);
  EXPECT_EQ(times.find({1, kRulesVersion})->time, (BestTime{10, "a"}));
  EXPECT_EQ(times.find({2, kRulesVersion})->time, (BestTime{9, "b"}));
  EXPECT_EQ(times.find({3, kRulesVersion})->time, (BestTime{8, "a"}));
}

// Each reads the file, adds its time and replaces it.
TEST_F(BestTimeStoreTest, ServersThatWriteAtOnceLoseNoTime) {
  constexpr std::uint64_t kLevels = 40;
  const auto serve = [this](std::uint64_t first) {
    for (std::uint64_t level = first; level < kLevels; level += 2) {
      BestTimes own;
      own.offer({level, kRulesVersion}, {{10, "Ann"}, kDate});
      while (!addBestTimes(path_, own.text()).empty()) continue;  // the other may hold the lock for long
    }
  };
  {
    const std::jthread even(serve, 0);
    const std::jthread odd(serve, 1);
  }
  EXPECT_EQ(timesIn(path_).size(), kLevels);
}

TEST_F(BestTimeStoreTest, ALockThatAnotherProgramKeepsIsNamed) {
  const OpenedFile lock = lockBeside(path_, WithoutLocks::kRefuse);
  ASSERT_TRUE(lock.file);
  EXPECT_EQ(addBestTimes(path_, ""), path_ + ": error: " + lockFault(path_ + ".lock"));
}

// What was removed from the file by hand does not come back with the next time.
TEST_F(BestTimeStoreTest, OnlyNewTimesAreAddedToTheFile) {
  BestTimeStore store = open();
  store.offer(1, {10, "Ann"});
  EXPECT_EQ(store.finish(), std::nullopt);
  writeText(path_, "");
  store.offer(2, {10, "Ann"});
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(timesIn(path_).size(), 1u);
}

TEST_F(BestTimeStoreTest, AFileThatWasDamagedMeanwhileIsNotChanged) {
  BestTimeStore store = open();
  writeText(path_, "damaged\n");
  store.offer(1, {10, "Ann"});
  const auto fault = store.finish();
  ASSERT_TRUE(fault);
  EXPECT_TRUE(fault->starts_with(path_ + ":1:1: error: ")) << *fault;
  EXPECT_EQ(readText(path_), "damaged\n");
  EXPECT_TRUE(store.pending());
  writeText(path_, "");
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(timesIn(path_).size(), 1u);
}

TEST_F(BestTimeStoreTest, AFileThatCannotBeWrittenIsReportedAndTriedAgain) {
  std::filesystem::create_directory(folder_ / "later");
  const std::string path = folder_ / "later/best_times";
  BestTimeStore store{clockOf, path, BestTimes()};
  std::filesystem::remove(folder_ / "later");
  store.offer(1, {10, "Ann"});
  std::optional<std::string> fault;
  ASSERT_TRUE(waitUntil([&] { return (fault = store.poll(kNow)).has_value(); }));
  EXPECT_TRUE(fault->starts_with(path + ": error: No such file or directory; ")) << *fault;
  std::filesystem::create_directory(folder_ / "later");
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(timesIn(path).size(), 1u);
}

TEST_F(BestTimeStoreTest, AMissingFileHasNoTimesButNeedsItsFolder) {
  EXPECT_TRUE(timesIn(path_).empty());
  const auto read = readBestTimes(folder_ / "no/best_times");
  ASSERT_TRUE(std::holds_alternative<std::vector<std::string>>(read));
  EXPECT_NE(std::get<std::vector<std::string>>(read).front().find("in a folder that exists"), std::string::npos);
}

TEST_F(BestTimeStoreTest, ADamagedFileIsRefusedWithThePlaceOfTheError) {
  writeText(path_, "\n0000000000000005 6 0 2026-01-01T00:00:00Z Cid\n");
  const auto read = readBestTimes(path_);
  ASSERT_TRUE(std::holds_alternative<std::vector<std::string>>(read));
  EXPECT_TRUE(std::get<std::vector<std::string>>(read).front().starts_with(path_ + ":2:20: error: "));
}

}  // namespace
}  // namespace platon::best_time_store_test
