#include "server/app/level_files.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::level_files_test {
namespace {

class LevelFilesTest : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    writeText(folder_ / name, text);
    return folder_ / name;
  }

  // Exit code and message.
  static std::string errorOf(const std::vector<std::string>& paths) {
    try {
      loadLevelFiles(paths);
      return "none";
    } catch (const ProgramError& error) {
      return std::to_string(error.exitCode()) + " " + error.what();
    }
  }

  const TemporaryFolder folder_;
};

TEST_F(LevelFilesTest, LoadsLevelsInTheGivenOrder) {
  const std::string far = write("far.level", farGoalText());
  const std::string near = write("near.level", nearGoalText());
  const LoadedLevels loaded = loadLevelFiles({near, far, near});
  ASSERT_EQ(loaded.levels.size(), 3u);
  EXPECT_EQ(loaded.levels[0]->text, nearGoalText());
  EXPECT_EQ(loaded.levels[1]->text, farGoalText());
  EXPECT_EQ(loaded.levels[2]->text, nearGoalText());
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST_F(LevelFilesTest, ErrorsOfAllFilesAreReported) {
  const std::string good = write("good.level", farGoalText());
  const std::string bad = write("bad.level", "HEXAHEDRON\n0 0 0 x\n");
  const std::string worse = write("worse.level", "CUBE\n");
  const std::string error = errorOf({good, bad, worse});
  EXPECT_TRUE(error.starts_with("3 " + bad + ":2:7: error: ")) << error;
  EXPECT_NE(error.find("\n" + worse + ":1:1: error: "), std::string::npos) << error;
}

TEST_F(LevelFilesTest, AtMostAHundredErrorsOfAFileAreReported) {
  std::string text = farGoalText();
  for (int i = 0; i < 250; ++i) text += "0 0 0 0\n";  // a warning each
  for (int i = 0; i < 150; ++i) text += "x\n";        // at least an error each
  const std::string bad = write("bad.level", text);
  const std::string errors = errorOf({bad});
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 100);
  EXPECT_EQ(errors.find(": warning: "), std::string::npos) << errors;
  EXPECT_TRUE(errors.ends_with(" more errors and warnings: platon-level check lists all")) << errors;
}

TEST_F(LevelFilesTest, AFileThatCannotBeReadIsAUsageError) {
  EXPECT_EQ(errorOf({"/no/such.level"}),
            "2 cannot read the level '/no/such.level': No such file or directory; name a readable level file");
  EXPECT_TRUE(errorOf({folder_.path()}).ends_with("Is a directory; name a readable level file"));
}

TEST_F(LevelFilesTest, AFileOfTheLargestSizeIsReadWholeAndALongerOneRefused) {
  std::string text = farGoalText();
  text.resize(kMaxLevelBytes, '\n');
  EXPECT_EQ(loadLevelFiles({write("longest.level", text)}).levels.at(0)->text.size(), kMaxLevelBytes);
  text += '\n';
  EXPECT_TRUE(errorOf({write("too_long.level", text)}).starts_with("3 "));
}

// The test runs in the build folder's program, so the levels come from the source tree.
TEST_F(LevelFilesTest, ShippedLevelsAreOrderedByFileName) {
  const std::vector<std::string> files = shippedLevelFiles();
  ASSERT_GT(files.size(), 1u);
  for (std::size_t i = 1; i < files.size(); ++i) {
    EXPECT_LE(std::filesystem::path(files[i - 1]).filename(), std::filesystem::path(files[i]).filename());
  }
  EXPECT_EQ(loadLevelFiles(files).levels.size(), files.size());
}

}  // namespace
}  // namespace platon::level_files_test
