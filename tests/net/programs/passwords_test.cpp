#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/net/support/server_fixture.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::passwords_test {
namespace {

/// Programs whose passwords and keys are in a folder.
class Passwords : public ServerTest {
 protected:
  std::string file(const std::string& password) const {
    const std::string path = folder_ / (password + ".txt");
    writeText(path, password + "\n");
    return path;
  }

  void startServerWith(const std::string& password) {
    startServer({"--key-file", folder_ / "key", "--password-file", file(password)});
  }

  ProcessResult runBots(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{address(), "--count", "2", "--seconds", "4", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runProcess(platonCommand("platon-bot", arguments));
  }

  static void expectRefusal(const ProcessResult& program, const std::string& sentence) {
    EXPECT_EQ(program.exitCode, 1);
    EXPECT_NE(program.errors.find(sentence), std::string::npos) << program.errors;
    EXPECT_NE(program.output.find("\"connected\":0,"), std::string::npos) << program.output;
  }

  void expectNobodyJoined() {
    stopServer();
    EXPECT_EQ(server().errors().find("joined"), std::string::npos) << server().errors();
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable dataHome_{"XDG_DATA_HOME", folder_.path()};
};

TEST_F(Passwords, BotsWithTheRightOnePlay) {
  startServerWith("sesame");
  const ProcessResult bots = runBots({"--password-file", file("sesame")});
  EXPECT_EQ(bots.exitCode, 0) << bots.errors;
  EXPECT_NE(bots.output.find("\"connected\":2,\"failed\":0,"), std::string::npos) << bots.output;
  EXPECT_NE(bots.output.find("\"hashMismatches\":0,"), std::string::npos) << bots.output;
  EXPECT_NE(server().errors().find("joined"), std::string::npos);
  stopServer();
}

TEST_F(Passwords, AWrongOneIsRefused) {
  startServerWith("sesame");
  expectRefusal(runBots({"--password-file", file("Sesame")}), address() + ": the password is wrong");
  expectNobodyJoined();
}

TEST_F(Passwords, WithoutOneTheBotsAreToldWhatToDo) {
  startServerWith("sesame");
  expectRefusal(runBots(), address() +
                               ": the server needs a password: write it to a file and name the file after "
                               "--password-file");
  expectNobodyJoined();
}

// A server that answers in the place of the right one would otherwise be joined.
TEST_F(Passwords, AServerThatDoesNotAskForOneIsNotJoined) {
  startServer();
  expectRefusal(runBots({"--password-file", file("sesame")}),
                address() + ": the server needs no password: join without one if that is right");
  expectNobodyJoined();
}

TEST_F(Passwords, AClientWithTheRightOnePlays) {
  startServerWith("sesame");
  Process client(
      platonCommand("platon-client", {address(), "--offscreen", "--seconds", "60", "--password-file", file("sesame")}));
  server().waitForError("joined");
  client.signal(SIGTERM);
  EXPECT_LE(client.wait(), 1) << client.errors();  // 1 if it has not received the level yet
  stopServer();
}

}  // namespace
}  // namespace platon::passwords_test
