#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/net/support/served_metrics.h"
#include "tests/net/support/server_fixture.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

// Clang's check of virtual tables opens a pipe to learn whether an address can be read.
#ifdef __has_feature
#define PLATON_CHECKS_NEED_DESCRIPTORS __has_feature(undefined_behavior_sanitizer)
#else
#define PLATON_CHECKS_NEED_DESCRIPTORS 0
#endif

namespace platon::server_recording_test {
namespace {

namespace fs = std::filesystem;

/// A server that records into a folder of its own.
class Recordings : public ServerTest {
 protected:
  void letBotsPlay() {
    Process bots(
        platonCommand("platon-bot", {address(), "--count", "3", "--seconds", "8", "--seed", "5", "--jitter", "20"}));
    EXPECT_EQ(bots.wait(), 0) << bots.errors();
  }

  std::vector<std::string> files() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path().string());
    return found;
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "games";
};

TEST_F(Recordings, AreCompleteWhenTheServerIsStopped) {
  startServer({"--record", folder_.string()});
  letBotsPlay();
  Process late(platonCommand("platon-bot", {address(), "--count", "1", "--seconds", "30"}));
  // One of the first bots, one of the later one.
  EXPECT_TRUE(waitUntil([this] { return files().size() == 2; }));
  stopServer();
  const std::vector<std::string> found = files();
  EXPECT_EQ(found.size(), 2u);
  for (const std::string& file : found) {
    Process verify(platonCommand("platon-sim", {"verify", file}));
    EXPECT_EQ(verify.wait(), 0) << verify.errors();
    EXPECT_NE(server().errors().find("recording finished file=\"" + file + "\" ticks="), std::string::npos)
        << server().errors();
  }
}

TEST_F(Recordings, AreValidUpToTheTickAtWhichTheServerWasKilled) {
  startServer({"--record", folder_.string()});
  Process bots(platonCommand("platon-bot", {address(), "--count", "3", "--seconds", "20", "--seed", "5"}));
  ASSERT_TRUE(waitUntil([this] { return files().size() == 1; }));
  const std::vector<std::string> found = files();
  const std::uintmax_t size = fs::file_size(found[0]);
  ASSERT_TRUE(waitUntil([&] { return fs::file_size(found[0]) > size; }));
  server().signal(SIGKILL);
  EXPECT_EQ(server().wait(), 128 + SIGKILL);
  Process verify(platonCommand("platon-sim", {"verify", found[0]}));
  EXPECT_EQ(verify.wait(), 3) << verify.errors();
  EXPECT_NE(verify.errors().find("the recording is truncated"), std::string::npos) << verify.errors();
  EXPECT_NE(verify.output().find("\nfirst tick 0\n"), std::string::npos) << verify.output();
}

// The bots leave before five seconds have passed.
TEST_F(Recordings, ShortRoundsLeaveNoFile) {
  startServer({"--record", folder_.string()});
  for (int visit = 0; visit < 2; ++visit) {
    Process bot(platonCommand("platon-bot", {address(), "--count", "1", "--seconds", "2"}));
    EXPECT_EQ(bot.wait(), 0) << bot.errors();
  }
  stopServer();
  EXPECT_TRUE(files().empty());
}

TEST_F(Recordings, OldOnesMakeRoom) {
  fs::create_directories(folder_);
  const fs::path old = folder_ / "20200101T000000Z-round-0001-old.recording";
  writeText(old, std::string(40 << 10, 'o'));
  startServer({"--record", folder_.string(), "--record-limit", "40K"});
  letBotsPlay();
  stopServer();
  EXPECT_FALSE(fs::exists(old));
  EXPECT_EQ(files().size(), 1u);
  EXPECT_NE(server().errors().find("recording removed file=\"" + old.string() + "\" bytes=40960"), std::string::npos)
      << server().errors();
}

// A limit on the size of files acts as a full disk.
TEST_F(Recordings, AFullDiskDoesNotEndTheMatch) {
  startServer({"--record", folder_.string(), "--metrics", "127.0.0.1:0"});
  const rlimit full{1000, RLIM_INFINITY};
  ASSERT_EQ(prlimit(server().id(), RLIMIT_FSIZE, &full, nullptr), 0);
  letBotsPlay();
  const std::string metrics = servedMetrics(server());
  EXPECT_NE(metrics.find("\nplaton_stopped_recordings_total 1\n"), std::string::npos) << metrics;
  stopServer();
  EXPECT_NE(server().errors().find("recording stopped file="), std::string::npos) << server().errors();
  EXPECT_NE(server().errors().find("reason=\"File too large\""), std::string::npos) << server().errors();
  EXPECT_TRUE(files().empty());
}

TEST_F(Recordings, AServerWithoutFileDescriptorsGoesOn) {
  if (PLATON_CHECKS_NEED_DESCRIPTORS) GTEST_SKIP() << "the sanitizer itself needs descriptors";
  startServer({"--record", folder_.string()});
  rlimit before{};
  ASSERT_EQ(prlimit(server().id(), RLIMIT_NOFILE, nullptr, &before), 0);
  const rlimit none{3, before.rlim_max};  // standard streams; poll refuses a smaller limit
  ASSERT_EQ(prlimit(server().id(), RLIMIT_NOFILE, &none, nullptr), 0);
  letBotsPlay();
  EXPECT_NE(server().waitForError("recording stopped file=").find("reason=\"Too many open files\""), std::string::npos);
  server().signal(SIGHUP);
  server().waitForError("configuration and levels not reloaded");
  ASSERT_EQ(prlimit(server().id(), RLIMIT_NOFILE, &before, nullptr), 0);
  letBotsPlay();
  stopServer();
  EXPECT_EQ(files().size(), 1u) << "the next round is recorded";
}

}  // namespace
}  // namespace platon::server_recording_test
