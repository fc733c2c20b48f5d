#include "protocol/files/kept_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "protocol/files/private_file.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::kept_file_test {
namespace {

constexpr auto kNot = FileReplacement::Wait::kNot;

std::string faultOf(const KeptFile& file) {
  const auto read = file.read();
  const auto* const error = std::get_if<ParseError>(&read);
  return error == nullptr ? "" : error->what;
}

class KeptFileTest : public testing::Test {
 protected:
  std::string add(const std::string& more) const {
    return file_.change([&](const std::string& text) { return text + more; }, kNot);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "made/kept";
  const KeptFile file_{path_, 10};
};

TEST_F(KeptFileTest, AMissingFileIsEmptyAndMadeByTheFirstChange) {
  EXPECT_EQ(std::get<std::string>(file_.read()), "");
  EXPECT_EQ(add("one "), "");
  EXPECT_EQ(add("two"), "");
  EXPECT_EQ(std::get<std::string>(file_.read()), "one two");
  EXPECT_EQ(std::filesystem::status(path_).permissions(), std::filesystem::perms(0600));
}

TEST_F(KeptFileTest, WhatCannotBeReadAsAWholeIsNotWritten) {
  std::filesystem::create_directory(folder_ / "made");
  writeText(path_, "too long by far");
  EXPECT_EQ(faultOf(file_), "it has more than 10 bytes");
  EXPECT_EQ(add("x"), "it has more than 10 bytes");
  EXPECT_EQ(readText(path_), "too long by far");
  std::filesystem::remove(path_);
  std::filesystem::create_symlink(path_, path_);
  EXPECT_EQ(faultOf(file_), "Too many levels of symbolic links");
  EXPECT_EQ(add("x"), "Too many levels of symbolic links");
  EXPECT_TRUE(std::filesystem::is_symlink(path_));
}

TEST_F(KeptFileTest, OneProgramAtATimeChangesIt) {
  const KeptFile file(path_, 1000);
  {
    std::vector<std::jthread> programs;
    for (int i = 0; i < 2; ++i) {
      programs.emplace_back([&file] {
        for (int n = 0; n < 50; ++n)
          EXPECT_EQ(file.change([](const std::string& text) { return text + "x"; }, kNot), "");
      });
    }
  }
  EXPECT_EQ(std::get<std::string>(file.read()), std::string(100, 'x'));
}

TEST_F(KeptFileTest, ALockThatIsKeptIsAFault) {
  std::filesystem::create_directory(folder_ / "made");
  const OpenedFile lock = lockBeside(path_.string(), WithoutLocks::kRefuse);
  ASSERT_TRUE(lock.file);
  EXPECT_EQ(add("x"), lockFault(path_.string() + ".lock"));
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(KeptFileTest, WithoutAPathNothingIsKept) {
  const KeptFile none({}, 10);
  EXPECT_EQ(none.change([](const std::string&) { return "x"; }, kNot), "");
  EXPECT_EQ(std::get<std::string>(none.read()), "");
}

}  // namespace
}  // namespace platon::kept_file_test
