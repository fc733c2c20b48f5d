#include "protocol/files/file_watch.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::file_watch_test {
namespace {

class FileWatchTest : public testing::Test {
 protected:
  void SetUp() override {
    writeText(folder_ / "a", "first");
    writeText(folder_ / "b", "first");
  }
  // The next look.
  bool look(FileWatch& watch) { return watch.poll(now_ += FileWatch::kInterval); }

  TemporaryFolder folder_;
  FileWatch::Time now_{std::chrono::hours(1)};
};

TEST_F(FileWatchTest, NoticesAChangeOnceTheFileStaysTheSame) {
  FileWatch watch({folder_ / "a", folder_ / "b"});
  EXPECT_FALSE(look(watch));
  writeText(folder_ / "b", "half of the");
  EXPECT_FALSE(look(watch)) << "it may still be being written";
  writeText(folder_ / "b", "half of the second");
  EXPECT_FALSE(look(watch));
  EXPECT_TRUE(look(watch));
  EXPECT_FALSE(look(watch)) << "only once";
}

TEST_F(FileWatchTest, NoticesAFileThatIsReplacedByAnotherOfTheSameLength) {
  FileWatch watch({folder_ / "a"});
  writeText(folder_ / "new", "other");
  std::filesystem::last_write_time(folder_ / "new",
                                   std::filesystem::last_write_time(folder_ / "a") + std::chrono::milliseconds(1));
  std::filesystem::rename(folder_ / "new", folder_ / "a");
  EXPECT_FALSE(look(watch));
  EXPECT_TRUE(look(watch));
}

TEST_F(FileWatchTest, NoticesThatAFileIsRemovedAndThatItIsBack) {
  FileWatch watch({folder_ / "a"});
  std::filesystem::remove(folder_ / "a");
  look(watch);
  EXPECT_TRUE(look(watch));
  EXPECT_FALSE(look(watch));
  writeText(folder_ / "a", "first");
  look(watch);
  EXPECT_TRUE(look(watch));
}

TEST_F(FileWatchTest, LooksOnceInAnInterval) {
  FileWatch watch({folder_ / "a"});
  EXPECT_FALSE(watch.poll(now_));
  writeText(folder_ / "a", "second");
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(watch.poll(now_ + std::chrono::milliseconds(i)));
  EXPECT_FALSE(look(watch));
  EXPECT_TRUE(look(watch));
}

}  // namespace
}  // namespace platon::file_watch_test
