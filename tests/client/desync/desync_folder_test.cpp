#include "client/desync/desync_folder.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

const DesyncReport kReport{"it was wrong", "all about it\n", {1, 2, 3}};

class MismatchFolderTest : public testing::Test {
 protected:
  std::string content(const char* name) const { return readText(folder_ / name); }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep";
};

TEST_F(MismatchFolderTest, WritesNothingWithoutAFolder) {
  EXPECT_EQ(DesyncFolder(fs::path()).keep(kReport), "it was wrong");
}

TEST_F(MismatchFolderTest, KeepsReportAndRecording) {
  EXPECT_EQ(DesyncFolder(folder_).keep(kReport), "it was wrong; see " + (folder_ / "desync-1.txt").string());
  EXPECT_EQ(content("desync-1.txt"),
            "all about it\n\nRecording of the own game: " + (folder_ / "desync-1.recording").string() + "\n");
  EXPECT_EQ(content("desync-1.recording"), "\1\2\3");
}

TEST_F(MismatchFolderTest, NeverFillsADisk) {
  for (int i = 0; i < DesyncFolder::kMaxReports; ++i) DesyncFolder(folder_).keep(kReport);
  const std::string said = DesyncFolder(folder_).keep({"it was wrong again", "", {}});
  EXPECT_TRUE(said.starts_with("it was wrong again; not written, for ")) << said;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2 * DesyncFolder::kMaxReports);
  EXPECT_EQ(content("desync-10.recording"), "\1\2\3");
}

TEST_F(MismatchFolderTest, NoReportNamesTheRecordingOfAnother) {
  DesyncFolder(folder_).keep(kReport);
  fs::remove(folder_ / "desync-1.txt");
  EXPECT_EQ(DesyncFolder(folder_).keep({"again", "", {4}}), "again; see " + (folder_ / "desync-2.txt").string());
  EXPECT_EQ(content("desync-1.recording"), "\1\2\3");
  EXPECT_EQ(content("desync-2.recording"), "\4");
}

TEST_F(MismatchFolderTest, SaysWhyNothingCouldBeWritten) {
  writeText(folder_, "a file");
  const std::string said = DesyncFolder(folder_).keep(kReport);
  EXPECT_TRUE(said.ends_with(": Not a directory")) << said;
}

}  // namespace
}  // namespace platon
