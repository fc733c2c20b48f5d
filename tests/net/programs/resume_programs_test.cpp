#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/net/support/server_fixture.h"
#include "tests/support/environment_variable.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::resume_programs_test {
namespace {

namespace fs = std::filesystem;

class ResumePrograms : public ServerTest {
 protected:
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
    for (const std::string& name : names) {
      ASSERT_TRUE(waitUntil([&] { return slotIn("joined", name) >= 0; })) << name;
    }
  }

  // Waits until the program has saved the token with which it can resume.
  void waitForFile() const {
    const fs::path folder = data_ / "platon/sessions";
    const auto isWritten = [](const auto& entry) { return entry.file_size() > 0; };
    EXPECT_TRUE(
        waitUntil([&] { return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(), isWritten); }));
  }

  // Ends a client that has joined. Its exit code is 1 if it has not received the level yet.
  void leave(Process& program, const std::string& name) {
    program.signal(SIGTERM);
    EXPECT_LE(program.wait(), 1) << program.errors();
    EXPECT_TRUE(waitUntil([&] { return slotIn("left", name) >= 0; })) << server().errors();
  }

  const TemporaryFolder data_;
  const EnvironmentVariable dataHome_{"XDG_DATA_HOME", data_.path()};
};

TEST_F(ResumePrograms, ClientsResumeAfterTheServerWasSuspended) {
  startServer();
  Process ann(platonCommand("platon-client", client("Ann")));
  waitForPlayers({"Ann"});
  Process ben(platonCommand("platon-client", client("Ben")));
  waitForPlayers({"Ben"});
  server().signal(SIGSTOP);
  ann.waitForError("reconnecting");
  ben.waitForError("reconnecting");
  server().signal(SIGCONT);
  for (Process* const program : {&ann, &ben}) {
    program->waitForError("reconnected");
    program->signal(SIGTERM);
    EXPECT_EQ(program->wait(), 0) << program->errors();
  }
  EXPECT_EQ(slotIn("resumed", "Ann"), slotIn("joined", "Ann"));
  EXPECT_EQ(slotIn("resumed", "Ben"), slotIn("joined", "Ben"));
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
  EXPECT_EQ(again.output() + again.errors() + ann.output() + ann.errors(), "");
  leave(again, "Ben");
  leave(ann, "Ann");
  EXPECT_TRUE(fs::is_empty(data_ / "platon/sessions"));
  stopServer();
}

TEST_F(ResumePrograms, AProgramDoesNotResumeAPlayerThatHasLeft) {
  startServer();
  for (int i = 0; i < 2; ++i) {
    Process ann(platonCommand("platon-client", client("Ann")));
    server().waitForError("joined client=" + std::to_string(i + 1));
    leave(ann, "Ann");
  }
  EXPECT_EQ(slotIn("resumed", "Ann"), -1);
  stopServer();
}

}  // namespace
}  // namespace platon::resume_programs_test
