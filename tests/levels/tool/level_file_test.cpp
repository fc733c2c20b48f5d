#include "levels/tool/level_file.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(readLevelFile(pathOf("level"), fault), content);
  EXPECT_EQ(fault, "");
  writeText(pathOf("empty"), "");
  EXPECT_EQ(readLevelFile(pathOf("empty"), fault), "");
}

TEST_F(LevelFileTest, ReadsOneByteMoreThanTheLongestLevel) {
  writeText(pathOf("longest"), std::string(kMaxLevelBytes, ' '));
  writeText(pathOf("longer"), std::string(kMaxLevelBytes + 1000, ' '));
  std::string fault;
  EXPECT_EQ(readLevelFile(pathOf("longest"), fault).value().size(), kMaxLevelBytes);
  EXPECT_EQ(readLevelFile(pathOf("longer"), fault).value().size(), kMaxLevelBytes + 1);
}

TEST_F(LevelFileTest, TellsWhyAFileCannotBeRead) {
  std::string fault;
  EXPECT_FALSE(readLevelFile(pathOf("absent"), fault));
  EXPECT_EQ(fault, "cannot read '" + pathOf("absent") + "': No such file or directory");
  EXPECT_FALSE(readLevelFile(pathOf(""), fault));
  EXPECT_EQ(fault, "cannot read '" + pathOf("") + "': Is a directory");
}

}  // namespace
}  // namespace platon::level_file_test
