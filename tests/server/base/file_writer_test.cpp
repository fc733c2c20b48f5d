#include "server/base/file_writer.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon {
namespace {

class FileWriterTest : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "file";
};

TEST_F(FileWriterTest, WritesTheContent) {
  FileWriter writer(path_);
  EXPECT_FALSE(writer.pending());
  writer.write("one");
  EXPECT_TRUE(writer.pending());
  EXPECT_TRUE(stepUntil([&] { EXPECT_EQ(writer.poll(), std::nullopt); }, [&] { return !writer.pending(); }));
  EXPECT_EQ(readText(path_), "one");
}

TEST_F(FileWriterTest, TheLastContentWins) {
  FileWriter writer(path_);
  for (int i = 0; i < 100; ++i) writer.write(std::to_string(i));
  EXPECT_TRUE(stepUntil([&] { EXPECT_EQ(writer.poll(), std::nullopt); }, [&] { return !writer.pending(); }));
  EXPECT_EQ(readText(path_), "99");
}

TEST_F(FileWriterTest, TheDestructorWritesWhatIsQueued) {
  {
    FileWriter writer(path_);
    for (int i = 0; i < 100; ++i) writer.write(std::to_string(i));
  }
  EXPECT_EQ(readText(path_), "99");
}

TEST_F(FileWriterTest, ReportsAFailureOnceAndStaysPending) {
  FileWriter writer(folder_ / "sub/file");
  writer.write("one");
  std::vector<std::string> faults;
  const auto poll = [&] {
    if (const auto fault = writer.poll()) faults.push_back(*fault);
  };
  EXPECT_TRUE(stepUntil(poll, [&] { return !faults.empty(); }));
  poll();
  EXPECT_EQ(faults, std::vector<std::string>{"No such file or directory"});
  EXPECT_TRUE(writer.pending());
  std::filesystem::create_directory(folder_ / "sub");
  writer.write("two");
  EXPECT_TRUE(stepUntil(poll, [&] { return !writer.pending(); }));
  EXPECT_EQ(readText(folder_ / "sub/file"), "two");
}

}  // namespace
}  // namespace platon
