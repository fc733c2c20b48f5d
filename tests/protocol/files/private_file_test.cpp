#include "protocol/files/private_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::private_file_test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

class PrivateFileTest : public testing::Test {
 protected:
  mode_t rights() const {
    struct stat status {};
    EXPECT_EQ(stat(path_.c_str(), &status), 0);
    return status.st_mode & 07777u;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "file";
};

TEST_F(PrivateFileTest, ANewFileIsForItsOwnerOnly) {
  const mode_t before = umask(0);
  EXPECT_TRUE(openPrivateFile(path_).file);
  umask(before);
  EXPECT_EQ(rights(), 0600u);
}

TEST_F(PrivateFileTest, AnOlderFileIsTakenFromOthersAndKeepsItsContent) {
  writeText(path_, "old");
  ASSERT_EQ(chmod(path_.c_str(), 0644), 0);
  EXPECT_TRUE(openPrivateFile(path_).file);
  EXPECT_EQ(rights(), 0600u);
  EXPECT_EQ(readText(path_), "old");
}

// Where anybody may write, somebody gives a second name to a file that he cannot change himself.
TEST_F(PrivateFileTest, AFileWithASecondNameKeepsItsRights) {
  writeText(folder_ / "other", "old");
  ASSERT_EQ(chmod((folder_ / "other").c_str(), 0644), 0);
  fs::create_hard_link(folder_ / "other", path_);
  EXPECT_TRUE(openPrivateFile(path_).file);
  EXPECT_EQ(rights(), 0644u);
}

TEST_F(PrivateFileTest, ALinkIsNotFollowed) {
  writeText(folder_ / "target", "mine");
  for (const char* target : {"target", "missing"}) {
    fs::create_symlink(target, path_);
    const OpenedFile opened = openPrivateFile(path_);
    EXPECT_FALSE(opened.file);
    EXPECT_EQ(opened.fault, "it is a symbolic link, not a regular file");
    fs::remove(path_);
  }
  EXPECT_EQ(readText(folder_ / "target"), "mine");
  EXPECT_FALSE(fs::exists(folder_ / "missing"));
}

TEST_F(PrivateFileTest, APipeIsRefusedAndNotWaitedFor) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(openPrivateFile(path_).fault, "it is a pipe, not a regular file");
}

TEST_F(PrivateFileTest, TheReasonOfTheSystemIsKept) {
  EXPECT_EQ(openPrivateFile(folder_ / "missing/file").fault, "No such file or directory");
  EXPECT_EQ(openPrivateFile(folder_.path()).fault, "Is a directory");
}

TEST_F(PrivateFileTest, ALockThatAnotherProgramHoldsIsTriedForALimitedTime) {
  const OpenedFile ours = openPrivateFile(path_);
  {
    const Descriptor theirs(open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    ASSERT_EQ(flock(theirs.number(), LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(lockFile(ours.file, milliseconds(0)), LockResult::kHeld);
    EXPECT_EQ(lockFile(ours.file, milliseconds(40)), LockResult::kHeld);
  }
  EXPECT_EQ(lockFile(ours.file, milliseconds(0)), LockResult::kLocked);
  EXPECT_EQ(lockFault(path_), "another program holds the lock on '" + path_ + "'; end that program or remove the file");
}

TEST_F(PrivateFileTest, ALockIsTakenWhenItsHolderLetsGo) {
  const OpenedFile ours = openPrivateFile(path_);
  Descriptor theirs(open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(flock(theirs.number(), LOCK_EX | LOCK_NB), 0);
  std::jthread holder([&theirs] { theirs = Descriptor(); });
  EXPECT_EQ(lockFile(ours.file, std::chrono::minutes(1)), LockResult::kLocked);
}

TEST_F(PrivateFileTest, WhatCannotBeLockedIsNotWaitedFor) {
  EXPECT_EQ(lockFile(Descriptor(), std::chrono::hours(1)), LockResult::kNoLocks);
}

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
}  // namespace platon::private_file_test
