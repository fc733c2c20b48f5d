#include "protocol/files/private_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
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

using Kind = KeptFile::Kind;
constexpr auto kNot = KeptFile::Wait::kNot;

std::string faultOf(const KeptFile& file) {
  const auto read = file.read();
  const auto* const error = std::get_if<ParseError>(&read);
  return error == nullptr ? "" : error->what;
}

class KeptFileTest : public testing::Test {
 protected:
  std::string addTo(const KeptFile& file, const std::string& more) const {
    return file.change([&](const std::string& text) { return text + more; }, kNot);
  }
  std::string add(const std::string& more) const { return addTo(file_, more); }
  fs::perms rights() const { return fs::status(path_).permissions(); }

  const TemporaryFolder folder_;
  const fs::path path_ = folder_ / "made/kept";
  const KeptFile file_{path_, 10};
};

TEST_F(KeptFileTest, AMissingFileIsEmptyAndMadeByTheFirstChange) {
  EXPECT_EQ(std::get<std::string>(file_.read()), "");
  EXPECT_EQ(add("one "), "");
  EXPECT_EQ(add("two"), "");
  EXPECT_EQ(std::get<std::string>(file_.read()), "one two");
}

TEST_F(KeptFileTest, AFileThatTheUserHasNamedNeedsItsFolder) {
  for (const Kind kind : {Kind::kNamed, Kind::kPublished}) {
    const KeptFile named(path_, 10, kind);
    const std::string fault =
        "No such file or directory; name a file that can be read and written, in a folder that exists";
    EXPECT_EQ(faultOf(named), fault);
    EXPECT_EQ(addTo(named, "x"), fault);
    EXPECT_FALSE(fs::exists(folder_ / "made"));
  }
}

TEST_F(KeptFileTest, WhoMayReadItDependsOnWhoseItIs) {
  fs::create_directory(folder_ / "made");
  const std::vector<std::pair<Kind, unsigned>> rightsOfNew{
      {Kind::kOwn, 0600}, {Kind::kNamed, 0600}, {Kind::kPublished, 0644}};
  for (const auto& [kind, rightsOf] : rightsOfNew) {
    const KeptFile file(path_, 10, kind);
    EXPECT_EQ(addTo(file, "x"), "");
    EXPECT_EQ(rights(), fs::perms(rightsOf));
    fs::permissions(path_, fs::perms(0640));
    EXPECT_EQ(addTo(file, "x"), "");
    EXPECT_EQ(rights(), fs::perms(kind == Kind::kOwn ? 0600 : 0640)) << "of an older file";
    fs::remove(path_);
  }
}

TEST_F(KeptFileTest, WhatCannotBeReadAsAWholeIsNotWritten) {
  std::filesystem::create_directory(folder_ / "made");
  writeText(path_, "too long by far");
  const std::string tooLong = "it has more than 10 bytes; remove lines that you do not need";
  EXPECT_EQ(faultOf(file_), tooLong);
  EXPECT_EQ(add("x"), tooLong);
  EXPECT_EQ(readText(path_), "too long by far");
  std::filesystem::remove(path_);
  std::filesystem::create_symlink(path_, path_);
  const std::string inACircle = "Too many levels of symbolic links; make it readable or move it away";
  EXPECT_EQ(faultOf(file_), inACircle);
  EXPECT_EQ(add("x"), inACircle);
  EXPECT_TRUE(std::filesystem::is_symlink(path_));
  fs::remove(path_);
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(add("x"), "it is a pipe, not a regular file; make it readable or move it away");
  EXPECT_TRUE(fs::is_fifo(path_));
}

TEST_F(KeptFileTest, WhatCouldNotBeReadAgainIsNotWritten) {
  EXPECT_EQ(add("0123456789"), "");
  EXPECT_EQ(add("x"), "it would have more than 10 bytes; remove lines that you do not need");
  EXPECT_EQ(readText(path_), "0123456789");
}

// The file may be on a disk that is not there yet.
TEST_F(KeptFileTest, ALinkToNothingStays) {
  fs::create_directory(folder_ / "made");
  fs::create_symlink("elsewhere", path_);
  const std::string fault = "it is a symbolic link to a missing file; make it readable or move it away";
  EXPECT_EQ(faultOf(file_), fault);
  EXPECT_EQ(add("x"), fault);
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_FALSE(fs::exists(folder_ / "made/elsewhere"));
  writeText(folder_ / "made/elsewhere", "old ");
  EXPECT_EQ(add("new"), "");
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(readText(folder_ / "made/elsewhere"), "old new");
}

TEST_F(KeptFileTest, AnEditThatRefusesOrChangesNothingLeavesTheFile) {
  EXPECT_EQ(add("old"), "");
  std::ifstream reader(path_);
  EXPECT_EQ(file_.change([](const std::string&) { return ParseError{"it is damaged"}; }), "it is damaged");
  EXPECT_THROW(file_.change([](const std::string&) -> std::string { throw std::runtime_error("damaged"); }),
               std::runtime_error);
  EXPECT_EQ(add(""), "");
  std::ofstream(path_) << "new";
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "new") << "another file has taken its place";
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
  const std::string path = path_.string() + ".lock";
  const OpenedFile lock = openPrivateFile(path);
  ASSERT_EQ(lockFile(lock.file), LockResult::kLocked);
  EXPECT_EQ(add("x"), "another program holds the lock on '" + path + "'; end that program");
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(KeptFileTest, AllThatLinkToAFileShareItsLock) {
  fs::create_directory(folder_ / "made");
  const fs::path target = fs::canonical(folder_ / "made") / "elsewhere";
  writeText(target, "");
  fs::create_symlink(target, path_);
  {
    const OpenedFile lock = openPrivateFile(target.string() + ".lock");
    ASSERT_EQ(lockFile(lock.file), LockResult::kLocked);
    EXPECT_EQ(add("x"), "another program holds the lock on '" + target.string() + ".lock'; end that program");
  }
  EXPECT_EQ(add("x"), "");
  EXPECT_FALSE(fs::exists(path_.string() + ".lock"));
}

// Others could hold the lock for ever otherwise.
TEST_F(KeptFileTest, TheLockIsForItsOwnerOnlyAndNotMadeElsewhere) {
  const std::string lock = path_.string() + ".lock";
  EXPECT_EQ(add("old"), "");
  EXPECT_EQ(fs::status(lock).permissions(), fs::perms(0600));
  fs::remove(lock);
  fs::create_symlink(folder_ / "victim", lock);
  EXPECT_EQ(add("new"), "'" + lock +
                            "' cannot be opened: it is a symbolic link, not a regular file; remove it, and let the "
                            "program write to its folder");
  EXPECT_FALSE(fs::exists(folder_ / "victim"));
}

TEST_F(KeptFileTest, WithoutAPathNothingIsKept) {
  const KeptFile none({}, 10);
  EXPECT_EQ(none.change([](const std::string&) { return "x"; }, kNot), "");
  EXPECT_EQ(std::get<std::string>(none.read()), "");
}

}  // namespace
}  // namespace platon::private_file_test
