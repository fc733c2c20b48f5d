#include "client/lobby/remembered.h"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"

namespace platon::remembered_test {
namespace {

// Called before a file is locked.
std::function<void()> beforeLock;

}  // namespace
}  // namespace platon::remembered_test

// Used by this program instead of that of the C library.
extern "C" int flock(int handle, int operation) noexcept {
  using platon::remembered_test::beforeLock;
  if (beforeLock) std::exchange(beforeLock, nullptr)();
  return static_cast<int>(syscall(SYS_flock, handle, operation));
}

namespace platon::remembered_test {
namespace {

const ServerAddress kHere{"example.org", 7777};
const ServerAddress kThere{"2001:db8::1", 7778};

std::string errorOf(const KnownServers& servers) {
  try {
    servers.find(kHere);
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    return error.what();
  }
  return "none";
}

TEST(KnownServers, RemembersTheKeyOfEachServer) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "platon/known_servers");
  EXPECT_EQ(servers.find(kHere), std::nullopt);
  servers.remember(kHere, CryptoKey{1});
  servers.remember(kThere, CryptoKey{2});
  EXPECT_EQ(servers.find(kHere), CryptoKey{1});
  EXPECT_EQ(servers.find(kThere), CryptoKey{2});
  EXPECT_EQ(servers.find({"example.org", 7778}), std::nullopt);
  EXPECT_EQ(readText(servers.file()),
            "example.org:7777 " + textOf(CryptoKey{1}) + "\n[2001:db8::1]:7778 " + textOf(CryptoKey{2}) + "\n");
}

TEST(KnownServers, TheFirstKeyStaysAndOtherLinesAreKept) {
  const TemporaryFolder folder;
  writeText(folder / "known_servers", "# mine\n\nexample.org:7777 " + textOf(CryptoKey{5}));
  const KnownServers servers(folder / "known_servers");
  servers.remember(kHere, CryptoKey{6});
  EXPECT_EQ(servers.find(kHere), CryptoKey{5});
  servers.remember(kThere, CryptoKey{7});
  EXPECT_TRUE(readText(servers.file()).starts_with("# mine\n"));
  EXPECT_EQ(servers.find(kThere), CryptoKey{7});
}

TEST(KnownServers, ADamagedLineIsAnErrorThatNamesIt) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  const std::string key = textOf(CryptoKey{5});
  const std::string other = "[2001:db8::1]:7778 " + key + "\n";
  for (const std::string& line :
       {"example.org:7777 " + key.substr(0, 42), "example.org:7777 " + key + "example.com:7777 " + key,
        std::string("example.org:7777"), std::string("exam"), std::string(20, '\0'), "example.org:77" + other,
        "example.org " + key}) {
    const std::string text = other + line + "\n";
    writeText(servers.file(), text);
    EXPECT_EQ(errorOf(servers), servers.file().string() +
                                    ":2: error: damaged line, expected HOST:PORT KEY; correct or remove it. If you "
                                    "remove it, the key of the server is saved again when you join");
    servers.remember(kHere, CryptoKey{6});
    EXPECT_EQ(readText(servers.file()), text);
  }
}

TEST(KnownServers, AFullDiskLeavesNoHalfLine) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  servers.remember(kThere, CryptoKey{2});
  const std::string before = readText(servers.file());
  {
    const FullDisk disk(before.size() + 10);
    servers.remember(kHere, CryptoKey{1});
  }
  EXPECT_EQ(readText(servers.file()), before);
  servers.remember(kHere, CryptoKey{1});
  EXPECT_EQ(servers.find(kHere), CryptoKey{1});
}

// Another client adds a line while this one waits for the lock.
TEST(KnownServers, LinesOfOtherClientsAreKept) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  const std::string here = "example.org:7777 " + textOf(CryptoKey{1}) + "\n";
  const std::string there = "[2001:db8::1]:7778 " + textOf(CryptoKey{2}) + "\n";
  beforeLock = [&] { writeText(servers.file(), there); };
  servers.remember(kHere, CryptoKey{1});
  EXPECT_EQ(readText(servers.file()), there + here);
  std::filesystem::remove(servers.file());
  beforeLock = [&] { writeText(servers.file(), here); };
  servers.remember(kHere, CryptoKey{3});
  EXPECT_EQ(readText(servers.file()), here) << "the first key stays";
  {
    const FullDisk disk(here.size() + there.size() + 10);
    beforeLock = [&] { writeText(servers.file(), here + there); };
    servers.remember({"example.com", 7777}, CryptoKey{4});
  }
  EXPECT_EQ(readText(servers.file()), here + there);
}

TEST(KnownServers, WithoutAFileNothingIsRemembered) {
  const KnownServers servers{std::filesystem::path()};
  servers.remember(kHere, CryptoKey{1});
  EXPECT_EQ(servers.find(kHere), std::nullopt);
}

TEST(KnownServers, TheFileIsForItsOwnerOnly) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  servers.remember(kHere, CryptoKey{1});
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(servers.file()).permissions(), perms(0600));
  std::filesystem::permissions(servers.file(), perms(0644));
  servers.remember(kThere, CryptoKey{2});
  EXPECT_EQ(std::filesystem::status(servers.file()).permissions(), perms(0600)) << "as earlier versions made it";
  EXPECT_EQ(servers.find(kHere), CryptoKey{1});
}

TEST(KnownServers, ALockThatAnotherProgramKeepsIsNamed) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  servers.remember(kThere, CryptoKey{2});
  const std::string path = servers.file().string();
  Process holder({"flock", path + ".lock", "sh", "-c", "echo locked && exec sleep 60"});
  holder.waitForOutput("locked");
  EXPECT_EQ(servers.remember(kHere, CryptoKey{1}), "cannot save the key of the server: " + path +
                                                       ": another program holds the lock on '" + path +
                                                       ".lock'; end that program");
  EXPECT_EQ(servers.find(kHere), std::nullopt);
}

TEST(KnownServers, ALinkIsFollowedToAFileAndMakesNone) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  std::filesystem::create_symlink("elsewhere", servers.file());
  EXPECT_EQ(servers.remember(kHere, CryptoKey{1}),
            "cannot save the key of the server: " + servers.file().string() +
                ": it is a symbolic link to a missing file; make it readable or move it away");
  EXPECT_EQ(errorOf(servers), servers.file().string() +
                                  ": error: it is a symbolic link to a missing file; make it readable or move it away")
      << "whether a server is known is not known";
  EXPECT_FALSE(std::filesystem::exists(folder / "elsewhere"));
  writeText(folder / "elsewhere", "");
  EXPECT_EQ(servers.remember(kHere, CryptoKey{1}), "");
  EXPECT_EQ(servers.find(kHere), CryptoKey{1});
  EXPECT_TRUE(std::filesystem::is_symlink(servers.file()));
}

TEST(KnownServers, WhatIsNoRegularFileOrTooLargeIsAnError) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "known_servers");
  const std::string path = servers.file().string();
  const auto expectRefused = [&](const std::string& why) {
    EXPECT_EQ(errorOf(servers), path + ": error: " + why);
    EXPECT_NE(servers.remember(kHere, CryptoKey{1}), "");
    std::filesystem::remove(path);
  };
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  expectRefused("it is a pipe, not a regular file; make it readable or move it away");
  std::filesystem::create_symlink("/dev/zero", path);
  expectRefused("it is a device, not a regular file; make it readable or move it away");
  writeText(path, std::string(std::size_t{1} << 20, '\n') + "\n");
  expectRefused("it has more than 1048576 bytes; remove lines that you do not need");
}

std::string textOf(const RecentServers& servers) {
  std::string text;
  for (const ServerAddress& server : servers.list()) text += server.text() + " ";
  return text;
}

TEST(RecentServers, TheNewestIsFirstAndNoneIsTwice) {
  const TemporaryFolder folder;
  const RecentServers servers(folder / "platon/recent_servers");
  EXPECT_EQ(textOf(servers), "");
  servers.remember({"first.example", 7777});
  servers.remember({"::1", 7778});
  servers.remember({"first.example", 7777});
  EXPECT_EQ(textOf(servers), "first.example:7777 [::1]:7778 ");
}

TEST(RecentServers, TheOldestAreForgotten) {
  const TemporaryFolder folder;
  const RecentServers servers(folder / "recent_servers");
  for (std::uint16_t port = 1; port <= 20; ++port) servers.remember({"host", port});
  EXPECT_EQ(servers.list().size(), RecentServers::kMaxServers);
  EXPECT_EQ(servers.list().front().port, 20);
}

TEST(RecentServers, DamagedLinesAreIgnored) {
  const TemporaryFolder folder;
  writeText(folder / "recent_servers", "no address!\n\nhost:70000\nhost:1\n\xff\n");
  const RecentServers servers(folder / "recent_servers");
  EXPECT_EQ(textOf(servers), "host:1 ");
  RecentServers("").remember({"host", 1});
  EXPECT_EQ(textOf(RecentServers("")), "");
}

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
  EXPECT_EQ(levels.add(7), "cannot save that the goal was reached: " + file_.string() +
                               ": Too many levels of symbolic links; make it readable or move it away");
  EXPECT_TRUE(levels.has(7)) << "until the program ends";
  EXPECT_EQ(levels.add(7), "") << "told once";
  EXPECT_TRUE(std::filesystem::is_symlink(file_));
}

TEST_F(ReachedLevelsTest, AFailureNamesTheFileAndWithoutAFileThereIsNone) {
  writeText(folder_ / "data", "a file");
  EXPECT_EQ(ReachedLevels(file_).add(7),
            "cannot save that the goal was reached: " + file_.string() +
                ": its folder cannot be made: Not a directory; make it, and let the program write to it");
  EXPECT_EQ(ReachedLevels({}).add(7), "");
}

}  // namespace
}  // namespace platon::remembered_test
