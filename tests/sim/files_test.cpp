#include "tests/sim/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/sim/sim_options.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::sim::files_test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class SimFilesTest : public testing::Test {
 protected:
  std::string pathOf(const std::string& name) const { return folder_ / name; }

 private:
  const TemporaryFolder folder_;
};

TEST_F(SimFilesTest, ReadsAtMostTheBytesAskedFor) {
  std::string text(100000, 'x');
  text[0] = '\0';
  text[99999] = '\xff';
  writeText(pathOf("file"), text);
  const std::vector<std::uint8_t> all(text.begin(), text.end());
  EXPECT_EQ(sim::readBytes(pathOf("file"), 1000000), all);
  EXPECT_EQ(sim::readBytes(pathOf("file"), 100000), all);
  EXPECT_EQ(sim::readBytes(pathOf("file"), 99999), std::vector<std::uint8_t>(all.begin(), all.end() - 1));
  EXPECT_EQ(sim::readBytes(pathOf("file"), 0), std::vector<std::uint8_t>());
}

TEST_F(SimFilesTest, RefusesFilesThatCannotBeRead) {
  EXPECT_THAT([&] { sim::readBytes(pathOf("absent"), 1); },
              ThrowsMessage<UsageError>("cannot read '" + pathOf("absent") + "': No such file or directory"));
  EXPECT_THAT([&] { sim::readBytes(pathOf(""), 1); }, ThrowsMessage<UsageError>(HasSubstr("Is a directory")));
}

TEST_F(SimFilesTest, ReplacesAnExistingFile) {
  writeText(pathOf("file"), "long content");
  OutputFile file(pathOf("file"));
  file.write("short");
  file.write(std::vector<std::uint8_t>{'!', 0});
  file.close();
  EXPECT_EQ(readText(pathOf("file")), std::string("short!\0", 7));
}

TEST_F(SimFilesTest, CreateNewRefusesAnExistingFile) {
  writeText(pathOf("file"), "content");
  EXPECT_THAT([&] { OutputFile(pathOf("file"), OutputFile::Mode::kCreateNew); },
              ThrowsMessage<UsageError>("cannot write '" + pathOf("file") + "': File exists"));
  EXPECT_EQ(readText(pathOf("file")), "content");
  OutputFile(pathOf("new"), OutputFile::Mode::kCreateNew).close();
  EXPECT_EQ(readText(pathOf("new")), "");
}

TEST_F(SimFilesTest, RefusesFilesThatCannotBeOpened) {
  EXPECT_THROW(OutputFile(pathOf("no such folder/file")), UsageError);
}

TEST_F(SimFilesTest, AFailedWriteIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  OutputFile file("/dev/full");
  file.write("text");
  EXPECT_THAT([&] { file.close(); }, ThrowsMessage<InputError>("cannot write to '/dev/full': No space left on device"));
}

}  // namespace
}  // namespace platon::sim::files_test
