#include "client/lobby/reached_levels.h"

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::reached_levels_test {
namespace {

class ReachedLevelsTest : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "data/reached_levels";
};

TEST_F(ReachedLevelsTest, AreKeptForTheNextStart) {
  ReachedLevels levels(file_);
  EXPECT_FALSE(levels.has(7));
  EXPECT_EQ(levels.add(7), "");
  EXPECT_EQ(levels.add(UINT64_MAX), "");
  EXPECT_EQ(levels.add(7), "");
  EXPECT_TRUE(levels.has(7));
  const ReachedLevels next(file_);
  EXPECT_TRUE(next.has(7));
  EXPECT_TRUE(next.has(UINT64_MAX));
  EXPECT_FALSE(next.has(8));
  EXPECT_EQ(readText(file_),
            "# Levels whose goal you have reached: the hash of each.\n0000000000000007\nffffffffffffffff\n");
}

TEST_F(ReachedLevelsTest, ThoseOfAnotherProgramStay) {
  ReachedLevels one(file_);
  ReachedLevels other(file_);
  one.add(1);
  other.add(2);
  const ReachedLevels next(file_);
  EXPECT_TRUE(next.has(1));
  EXPECT_TRUE(next.has(2));
}

// Two programs that had read it at the same time lost one of two levels.
TEST_F(ReachedLevelsTest, ProgramsThatAddAtTheSameTimeLoseNone) {
  std::vector<std::jthread> programs;
  for (std::uint64_t program = 0; program < 2; ++program) {
    programs.emplace_back([this, program] {
      ReachedLevels levels(file_);
      for (std::uint64_t n = 0; n < 20; ++n) EXPECT_EQ(levels.add(2 * n + program), "");
    });
  }
  programs.clear();
  const ReachedLevels all(file_);
  for (std::uint64_t level = 0; level < 40; ++level) EXPECT_TRUE(all.has(level)) << level;
}

TEST_F(ReachedLevelsTest, WhatIsNoHashIsLeftOut) {
  std::filesystem::create_directories(file_.parent_path());
  writeText(file_, "# x\n\n7\n00000000000000AB\n00000000000000ab\n00000000000000cd 5\n");
  EXPECT_TRUE(ReachedLevels(file_).has(0xab));
  EXPECT_FALSE(ReachedLevels(file_).has(7));
  EXPECT_FALSE(ReachedLevels(file_).has(0xcd));
}

TEST_F(ReachedLevelsTest, TheFirstOfTooManyAreForgotten) {
  std::filesystem::create_directories(file_.parent_path());
  std::string text;
  for (std::size_t i = 1; i <= ReachedLevels::kMaxLevels; ++i) {
    const std::string digits = std::to_string(i);
    text += std::string(16 - digits.size(), '0') + digits + "\n";
  }
  writeText(file_, text);
  ReachedLevels levels(file_);
  levels.add(0xff);
  EXPECT_FALSE(levels.has(1));
  EXPECT_TRUE(ReachedLevels(file_).has(2));
  EXPECT_TRUE(ReachedLevels(file_).has(0xff));
}

// It may be readable again at the next start.
TEST_F(ReachedLevelsTest, AFileThatCannotBeReadIsNotReplaced) {
  std::filesystem::create_directories(file_.parent_path());
  std::filesystem::create_symlink(file_, file_);
  ReachedLevels levels(file_);
  EXPECT_EQ(levels.add(7),
            "that the goal was reached is not kept: " + file_.string() + ": Too many levels of symbolic links");
  EXPECT_TRUE(levels.has(7)) << "until the program ends";
  EXPECT_EQ(levels.add(7), "") << "told once";
  EXPECT_TRUE(std::filesystem::is_symlink(file_));
}

TEST_F(ReachedLevelsTest, AFailureNamesTheFileAndWithoutAFileThereIsNone) {
  writeText(folder_ / "data", "a file");
  EXPECT_EQ(ReachedLevels(file_).add(7),
            "that the goal was reached is not kept: " + file_.string() + ": '" + file_.string() +
                ".lock' cannot be opened: Not a directory; remove it, and let the program write to its folder");
  EXPECT_EQ(ReachedLevels({}).add(7), "");
}

}  // namespace
}  // namespace platon::reached_levels_test
