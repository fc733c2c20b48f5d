#include "client/replay/facts_reader.h"

#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/protocol/work/no_thread.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::facts_reader_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecording = "levels/data/ways/01_run_and_jump.recording";

// As the list of a folder has it.
DatedFile dated(const fs::path& file) { return {file, fs::file_size(file), fs::last_write_time(file)}; }

class FactsReaderTest : public testing::Test {
 protected:
  FactsReaderTest() { writeText(file_, readText(kRecording)); }

  bool waitFor(const fs::path& file) {
    return waitUntil([&] {
      reader_.poll();
      return reader_.find(file) != nullptr;
    });
  }

  const TemporaryFolder folder_;
  const fs::path file_ = folder_ / "file";
  FactsReader reader_;
};

TEST_F(FactsReaderTest, ReadsEachFileOnce) {
  writeText(folder_ / "text", "no recording");
  reader_.read({dated(file_), dated(folder_ / "text")});
  ASSERT_TRUE(waitFor(folder_ / "text"));
  EXPECT_TRUE(reader_.find(file_)->ticks);
  EXPECT_EQ(reader_.find(folder_ / "text")->note, "is not a recording");
  reader_.read({dated(file_)});
  EXPECT_NE(reader_.find(file_), nullptr) << "remembered";
  EXPECT_EQ(reader_.find(folder_ / "text"), nullptr) << "forgotten";
  EXPECT_FALSE(reader_.poll());
}

TEST_F(FactsReaderTest, AChangedFileIsReadAgain) {
  reader_.read({dated(file_)});
  ASSERT_TRUE(waitFor(file_));
  fs::last_write_time(file_, fs::last_write_time(file_) - std::chrono::hours(1));
  reader_.read({dated(file_)});
  EXPECT_EQ(reader_.find(file_), nullptr);
  writeText(file_, "no recording");
  reader_.read({dated(file_)});
  ASSERT_TRUE(waitFor(file_));
  EXPECT_EQ(reader_.find(file_)->note, "is not a recording");
}

TEST_F(FactsReaderTest, AGrowingOrVanishedFileSaysSo) {
  DatedFile before = dated(file_);
  before.bytes -= 1;
  reader_.read({before});
  ASSERT_TRUE(waitFor(file_));
  EXPECT_EQ(reader_.find(file_)->note, "is still being written; open this page again later");
  const DatedFile gone = dated(file_);
  fs::remove(file_);
  reader_.read({gone});
  ASSERT_TRUE(waitFor(file_));
  EXPECT_EQ(reader_.find(file_)->note, "cannot be read: No such file or directory");
}

TEST_F(FactsReaderTest, WithoutAThreadOneFileIsReadAtATime) {
  FactsReader reader(noThread);
  std::vector<fs::path> files;
  for (const char* const name : {"a", "b", "c"}) {
    files.push_back(folder_ / name);
    writeText(files.back(), readText(kRecording));
  }
  reader.read({dated(files[0]), dated(files[1]), dated(files[2])});
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(reader.find(files[i]), nullptr);
    EXPECT_TRUE(reader.poll());
    ASSERT_NE(reader.find(files[i]), nullptr);
    EXPECT_TRUE(reader.find(files[i])->ticks);
  }
  EXPECT_EQ(reader.find(files[0])->level, reader.find(files[2])->level) << "kept once";
  EXPECT_FALSE(reader.poll());
  reader.read({dated(file_)});
  EXPECT_TRUE(reader.poll());
  EXPECT_TRUE(reader.find(file_)->ticks);
}

TEST_F(FactsReaderTest, CanEndWhileItReads) {
  for (int i = 0; i < 5; ++i) {
    FactsReader reader;
    reader.read({dated(file_)});
  }
}

}  // namespace
}  // namespace platon::facts_reader_test
