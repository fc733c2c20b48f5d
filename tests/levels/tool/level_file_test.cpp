#include "levels/tool/level_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "platon/game/level.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::level_file_test {
namespace {

class LevelFileTest : public testing::Test {
 protected:
  std::string pathOf(const std::string& name) const { return folder_ / name; }

 private:
  const TemporaryFolder folder_;
};

TEST_F(LevelFileTest, ReadsEveryByte) {
  const std::string content("a\0b\r\n\xff", 6);
  writeText(pathOf("level"), content);
  std::string fault;
  EXPECT_EQ(readInputFile(pathOf("level"), 100, fault), content);
  EXPECT_EQ(fault, "");
  writeText(pathOf("empty"), "");
  EXPECT_EQ(readInputFile(pathOf("empty"), 100, fault), "");
}

TEST_F(LevelFileTest, ReadsNoMoreBytesThanAllowed) {
  writeText(pathOf("longest"), std::string(kMaxLevelBytes, ' '));
  writeText(pathOf("longer"), std::string(kMaxLevelBytes + 1000, ' '));
  std::string fault;
  EXPECT_EQ(readInputFile(pathOf("longest"), kMaxLevelBytes + 1, fault).value().size(), kMaxLevelBytes);
  EXPECT_EQ(readInputFile(pathOf("longer"), kMaxLevelBytes + 1, fault).value().size(), kMaxLevelBytes + 1);
}

TEST_F(LevelFileTest, TellsWhyAFileCannotBeRead) {
  std::string fault;
  EXPECT_FALSE(readInputFile(pathOf("absent"), 100, fault));
  EXPECT_EQ(fault, "cannot read '" + pathOf("absent") + "': No such file or directory; name a readable file");
  EXPECT_FALSE(readInputFile(pathOf(""), 100, fault));
  EXPECT_EQ(fault, "cannot read '" + pathOf("") + "': Is a directory; name a readable file");
}

TEST_F(LevelFileTest, APipeIsReadAndADeviceIsNot) {
  std::string fault;
  ASSERT_EQ(mkfifo(pathOf("pipe").c_str(), 0600), 0);
  EXPECT_EQ(readInputFile(pathOf("pipe"), 100, fault), "") << "nobody writes to it";
  EXPECT_FALSE(readInputFile("/dev/zero", 100, fault));
  EXPECT_EQ(fault, "cannot read '/dev/zero': it is a device, not a regular file; name a readable file");
}

}  // namespace
}  // namespace platon::level_file_test
