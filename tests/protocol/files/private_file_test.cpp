#include "protocol/files/private_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <filesystem>
#include <thread>

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

}  // namespace
}  // namespace platon::private_file_test
