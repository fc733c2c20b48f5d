#include "client/desync/desync_folder.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/support/files.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"

namespace platon::desync_folder_test {
namespace {

namespace fs = std::filesystem;

const DesyncReport kReport{"a desync", "details\n", {1, 2, 3}};

class DesyncFolderTest : public testing::Test {
 protected:
  std::string content(const char* name) const { return readText(folder_ / name); }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep";
};

TEST_F(DesyncFolderTest, WritesNothingWithoutAPath) { EXPECT_EQ(DesyncFolder(fs::path()).write(kReport), "a desync"); }

TEST_F(DesyncFolderTest, WritesReportAndRecording) {
  EXPECT_EQ(DesyncFolder(folder_).write(kReport), "a desync; see " + (folder_ / "desync-1.txt").string());
  EXPECT_EQ(content("desync-1.txt"),
            "details\n\nRecording of the client's game: " + (folder_ / "desync-1.recording").string() + "\n");
  EXPECT_EQ(content("desync-1.recording"), "\1\2\3");
}

TEST_F(DesyncFolderTest, WritesAtMostTenReports) {
  for (int i = 0; i < DesyncFolder::kMaxReports; ++i) DesyncFolder(folder_).write(kReport);
  const std::string said = DesyncFolder(folder_).write({"a desync again", "", {}});
  EXPECT_TRUE(said.starts_with("a desync again; not written: ")) << said;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2 * DesyncFolder::kMaxReports);
  EXPECT_EQ(content("desync-10.recording"), "\1\2\3");
}

TEST_F(DesyncFolderTest, NeverOverwritesARecording) {
  DesyncFolder(folder_).write(kReport);
  fs::remove(folder_ / "desync-1.txt");
  EXPECT_EQ(DesyncFolder(folder_).write({"again", "", {4}}), "again; see " + (folder_ / "desync-2.txt").string());
  EXPECT_EQ(content("desync-1.recording"), "\1\2\3");
  EXPECT_EQ(content("desync-2.recording"), "\4");
}

TEST_F(DesyncFolderTest, OnAFullDiskNoPartOfAReportIsLeft) {
  const FullDisk full(2);
  const std::string said = DesyncFolder(folder_).write(kReport);
  EXPECT_EQ(said, "a desync; cannot write " + (folder_ / "desync-1.recording").string() + ": File too large");
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(DesyncFolderTest, NamesTheErrorWhenItCannotWrite) {
  writeText(folder_, "a file");
  const std::string said = DesyncFolder(folder_).write(kReport);
  EXPECT_TRUE(said.ends_with(": Not a directory")) << said;
}

}  // namespace
}  // namespace platon::desync_folder_test
