#include "protocol/files/file_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "tests/protocol/work/no_thread.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::file_writer_test {
namespace {

using namespace std::chrono_literals;

constexpr FileWriter::Time kNow{1h};

/// Keeps tasks until they are run: a disk that does not answer yet.
class KeptTasks {
 public:
  ThreadStart start() {
    return [this](std::function<void()> run) {
      tasks_.push_back(std::move(run));
      return std::thread();
    };
  }
  /// Runs the kept tasks; returns their number.
  std::size_t run() {
    const auto tasks = std::exchange(tasks_, {});
    for (const auto& task : tasks) task();
    return tasks.size();
  }

 private:
  std::vector<std::function<void()>> tasks_;
};

class FileWriterTest : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "file";
  KeptTasks tasks_;
};

TEST_F(FileWriterTest, WritesTheContent) {
  FileWriter writer(path_);
  EXPECT_FALSE(writer.pending());
  writer.write("one");
  EXPECT_TRUE(writer.pending());
  EXPECT_TRUE(stepUntil([&] { EXPECT_EQ(writer.poll(kNow), std::nullopt); }, [&] { return !writer.pending(); }));
  EXPECT_EQ(readText(path_), "one");
}

TEST_F(FileWriterTest, WritesInAnotherWayIfOneIsGiven) {
  FileWriter writer(path_, startThread, [](const std::string& path, std::string_view content) {
    return replaceTextFile(path, readText(path) + std::string(content));
  });
  replaceTextFile(path_, "old ");
  writer.write("new");
  EXPECT_EQ(writer.finish(), std::nullopt);
  EXPECT_EQ(readText(path_), "old new");
}

TEST_F(FileWriterTest, TheLastContentWins) {
  FileWriter writer(path_);
  for (int i = 0; i < 100; ++i) writer.write(std::to_string(i));
  EXPECT_TRUE(stepUntil([&] { EXPECT_EQ(writer.poll(kNow), std::nullopt); }, [&] { return !writer.pending(); }));
  EXPECT_EQ(readText(path_), "99");
}

TEST_F(FileWriterTest, TheDestructorWritesWhatIsQueued) {
  {
    FileWriter writer(path_);
    for (int i = 0; i < 100; ++i) writer.write(std::to_string(i));
  }
  EXPECT_EQ(readText(path_), "99");
}

TEST_F(FileWriterTest, TriesAgainAfterAFailureAtABoundedRate) {
  FileWriter writer(folder_ / "sub/file", tasks_.start());
  writer.write("one");
  EXPECT_EQ(writer.poll(kNow), std::nullopt);
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.poll(kNow), "No such file or directory");
  EXPECT_TRUE(writer.pending());
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval - 1ms), std::nullopt);
  EXPECT_EQ(tasks_.run(), 0u) << "too early";
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), std::nullopt);
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), std::nullopt) << "it is said once";
  std::filesystem::create_directory(folder_ / "sub");
  EXPECT_EQ(writer.poll(kNow + 2 * FileWriter::kRetryInterval), std::nullopt);
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.poll(kNow + 2 * FileWriter::kRetryInterval), std::nullopt);
  EXPECT_FALSE(writer.pending());
  EXPECT_EQ(readText(folder_ / "sub/file"), "one");
}

TEST_F(FileWriterTest, EveryFailureIsCountedAlsoThoseThatAreNotSaidAgain) {
  FileWriter writer(folder_ / "sub/file", noThread);
  writer.write("one");
  for (int tries = 0; tries < 3; ++tries) {
    EXPECT_EQ(writer.failures(), static_cast<std::uint64_t>(tries));
    writer.poll(kNow + tries * FileWriter::kRetryInterval);
    writer.poll(kNow + tries * FileWriter::kRetryInterval);
  }
  EXPECT_EQ(writer.failures(), 3u);
  std::filesystem::create_directory(folder_ / "sub");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(writer.poll(kNow + 3 * FileWriter::kRetryInterval), std::nullopt);
  EXPECT_FALSE(writer.pending());
  EXPECT_EQ(writer.failures(), 3u);
}

TEST_F(FileWriterTest, ADiskThatDoesNotAnswerIsAFailure) {
  FileWriter writer(path_, tasks_.start());
  writer.write("one");
  EXPECT_EQ(writer.poll(kNow), std::nullopt);
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval - 1ms), std::nullopt);
  EXPECT_EQ(writer.failures(), 0u);
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), "the disk does not answer");
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), std::nullopt);
  EXPECT_EQ(writer.failures(), 1u);
  EXPECT_EQ(writer.poll(kNow + 2 * FileWriter::kRetryInterval), std::nullopt) << "it is said once";
  EXPECT_EQ(writer.failures(), 2u);
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.poll(kNow + 2 * FileWriter::kRetryInterval), std::nullopt);
  EXPECT_FALSE(writer.pending());
  EXPECT_EQ(readText(path_), "one");
}

// It waited until the time at which the silent write would have been tried again.
TEST_F(FileWriterTest, ANewContentIsWrittenAtOnceWhenASilentDiskHasAnswered) {
  FileWriter writer(path_, tasks_.start());
  writer.write("one");
  EXPECT_EQ(writer.poll(kNow), std::nullopt);
  writer.write("two");
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), "the disk does not answer");
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), std::nullopt);
  EXPECT_EQ(tasks_.run(), 1u) << "of the second content";
  EXPECT_EQ(writer.poll(kNow + FileWriter::kRetryInterval), std::nullopt);
  EXPECT_FALSE(writer.pending());
  EXPECT_EQ(readText(path_), "two");
}

TEST_F(FileWriterTest, TheDestructorDoesNotTryAgainAfterFinish) {
  {
    FileWriter writer(path_, tasks_.start());
    writer.write("one");
    EXPECT_EQ(writer.finish(1ms), "the disk does not answer");
    writer.write("two");
    EXPECT_EQ(tasks_.run(), 1u);
    EXPECT_EQ(writer.finish(1ms), "the disk does not answer");
  }
  EXPECT_EQ(tasks_.run(), 1u) << "none was added by the destructor";
}

TEST_F(FileWriterTest, ANewContentIsTriedAtOnceAndItsFailureIsReported) {
  FileWriter writer(folder_ / "sub/file", noThread);
  for (const char* content : {"one", "two"}) {
    writer.write(content);
    EXPECT_EQ(writer.poll(kNow), std::nullopt);
    EXPECT_EQ(writer.poll(kNow), "No such file or directory");
  }
}

TEST_F(FileWriterTest, WithoutAThreadPollWrites) {
  FileWriter writer(path_, noThread);
  writer.write("one");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(writer.poll(kNow), std::nullopt);
  EXPECT_FALSE(writer.pending());
  EXPECT_EQ(readText(path_), "one");
  writer.write("two");
  EXPECT_EQ(writer.finish(), std::nullopt);
  EXPECT_EQ(readText(path_), "two");
}

TEST_F(FileWriterTest, DoesNotWaitWithoutEndForAStuckDisk) {
  FileWriter writer(path_, tasks_.start());
  writer.write("one");
  EXPECT_EQ(writer.poll(kNow), std::nullopt);
  writer.write("two");
  EXPECT_EQ(writer.finish(1ms), "the disk does not answer");
  EXPECT_TRUE(writer.pending());
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.finish(1ms), "the disk does not answer") << "of the second content";
  EXPECT_EQ(tasks_.run(), 1u);
  EXPECT_EQ(writer.finish(1ms), std::nullopt);
  EXPECT_EQ(readText(path_), "two");
}

}  // namespace
}  // namespace platon::file_writer_test
