#include "client/play/replace_file.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

class ReplaceFileTest : public testing::Test {
 protected:
  auto filesInFolder() const { return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()); }

  const TemporaryFolder folder_;
  const fs::path path_ = folder_ / "file";
};

TEST_F(ReplaceFileTest, CreatesAndReplacesAndLeavesNothingElse) {
  EXPECT_EQ(replaceFile(path_, "one"), std::nullopt);
  EXPECT_EQ(replaceFile(path_, "two"), std::nullopt);
  EXPECT_EQ(readText(path_), "two");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(ReplaceFileTest, KeepsTheAccessRights) {
  writeText(path_, "one");
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(replaceFile(path_, "two"), std::nullopt);
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(ReplaceFileTest, KeepsASymbolicLink) {
  writeText(path_, "one");
  const fs::path link = folder_ / "link";
  fs::create_symlink(path_, link);
  EXPECT_EQ(replaceFile(link, "two"), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(readText(path_), "two");
}

TEST_F(ReplaceFileTest, SaysWhyItFailedAndLeavesNothing) {
  fs::create_directory(path_);
  writeText(path_ / "inside", "");
  const auto fault = replaceFile(path_, "text");
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->find("cannot replace"), std::string::npos);
  EXPECT_EQ(filesInFolder(), 1);
  EXPECT_NE(replaceFile(folder_ / "missing" / "file", "text").value_or("").find("cannot write"), std::string::npos);
}

}  // namespace
}  // namespace platon
