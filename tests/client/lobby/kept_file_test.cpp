#include "client/lobby/kept_file.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::kept_file_test {
namespace {

TEST(KeptFile, AMissingFileIsEmptyAndOneThatCannotBeReadIsNot) {
  const TemporaryFolder folder;
  writeText(folder / "file", "text");
  std::filesystem::create_symlink(folder / "loop", folder / "loop");
  EXPECT_EQ(readKeptFile(folder / "file", 100), "text");
  EXPECT_EQ(readKeptFile(folder / "missing", 100), "");
  EXPECT_EQ(readKeptFile(folder / "no_folder/missing", 100), "");
  EXPECT_EQ(readKeptFile(folder.path(), 100), std::nullopt);
  EXPECT_EQ(readKeptFile(folder / "loop", 100), std::nullopt);
}

}  // namespace
}  // namespace platon::kept_file_test
