#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/server_fixture.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

class ResumePrograms : public ServerTest {
 protected:
  ResumePrograms() { setenv("XDG_DATA_HOME", data_.path().c_str(), 1); }

  std::vector<std::string> client(const std::string& name) const {
    return {address(), "--offscreen", "--name", name, "--seconds", "60"};
  }

  // Slot of the player in the first line of the server's log with this message and name; -1 if there is none.
  int slotIn(const std::string& message, const std::string& name) {
    const std::string log = server().errors();
    for (std::size_t at = 0; (at = log.find(message + " client=", at)) != std::string::npos; ++at) {
      const std::string line = log.substr(at, log.find('\n', at) - at);
      const std::size_t slot = line.find("slot=");
      if (line.ends_with("name=\"" + name + "\"")) return std::stoi(line.substr(slot + 5));
    }
    return -1;
  }

  void waitForPlayers(const std::vector<std::string>& names) {
    const auto end = std::chrono::steady_clock::now() + seconds(20);
    for (const std::string& name : names) {
      while (slotIn("joined", name) < 0 && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
      ASSERT_GE(slotIn("joined", name), 0) << name;
    }
  }

  // Waits until the program has saved the token with which it can resume.
  void waitForFile() const {
    const fs::path folder = data_ / "platon/sessions";
    const auto isWritten = [](const auto& entry) { return entry.file_size() > 0; };
    const auto end = std::chrono::steady_clock::now() + seconds(20);
    while (std::chrono::steady_clock::now() < end) {
      if (std::any_of(fs::directory_iterator(folder), fs::directory_iterator(), isWritten)) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    FAIL() << "no token is saved";
  }

  // Waits before leaving: a client that leaves before it plays exits with 1.
  static void leave(Process& program) {
    std::this_thread::sleep_for(seconds(2));
    program.signal(SIGTERM);
    EXPECT_EQ(program.wait(), 0) << program.errors();
  }

  const TemporaryFolder data_;
};

TEST_F(ResumePrograms, ClientsResumeAfterTheServerWasSuspended) {
  startServer();
  Process ann(platonCommand("platon-client", client("Ann")));
  waitForPlayers({"Ann"});
  Process bots(platonCommand("platon-bot", {address(), "--count", "1", "--seconds", "14", "--json"}));
  server().waitForError("joined client=2");
  server().signal(SIGSTOP);
  ann.waitForError("reconnecting");
  std::this_thread::sleep_for(seconds(2));
  server().signal(SIGCONT);
  ann.waitForError("reconnected");
  server().waitForError("resumed");
  EXPECT_EQ(bots.wait(), 0) << bots.errors();
  EXPECT_NE(bots.output().find("\"resumes\":1"), std::string::npos) << bots.output();
  EXPECT_EQ(slotIn("resumed", "Ann"), slotIn("joined", "Ann"));
  leave(ann);
  stopServer();
}

TEST_F(ResumePrograms, AProgramResumesThePlayerOfAKilledProgram) {
  startServer();
  Process ben(platonCommand("platon-client", client("Ben")));
  waitForPlayers({"Ben"});
  Process ann(platonCommand("platon-client", client("Ann")));
  waitForPlayers({"Ben", "Ann"});
  EXPECT_EQ(slotIn("joined", "Ben"), 0);
  EXPECT_EQ(slotIn("joined", "Ann"), 1);  // two programs, two players
  waitForFile();
  ben.signal(SIGKILL);
  EXPECT_EQ(ben.wait(), 128 + SIGKILL);
  Process again(platonCommand("platon-client", client("Ben")));
  server().waitForError("resumed");
  EXPECT_EQ(slotIn("resumed", "Ben"), 0);
  EXPECT_EQ(slotIn("resumed", "Ann"), -1);
  leave(again);
  leave(ann);
  EXPECT_EQ(again.output() + again.errors() + ann.output() + ann.errors(), "");
  EXPECT_TRUE(fs::is_empty(data_ / "platon/sessions"));
  stopServer();
}

TEST_F(ResumePrograms, AProgramDoesNotResumeAPlayerThatHasLeft) {
  startServer();
  for (int i = 0; i < 2; ++i) {
    Process ann(platonCommand("platon-client", client("Ann")));
    server().waitForError("joined client=" + std::to_string(i + 1));
    leave(ann);
  }
  EXPECT_EQ(slotIn("resumed", "Ann"), -1);
  stopServer();
}

}  // namespace
}  // namespace platon
