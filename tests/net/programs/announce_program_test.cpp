// The programs with a list of servers that a web server publishes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "protocol/transport/server_address.h"
#include "protocol/transport/udp_socket.h"
#include "tests/client/lobby/web_server.h"
#include "tests/net/support/enet_client.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::announce_program_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class AnnounceProgramTest : public testing::Test {
 protected:
  // The server must know its port before it starts.
  static std::string freeAddress() { return UdpSocket("127.0.0.1", 0).address().text(); }

  void setName(const std::string& name) const { writeText(config_, "name = \"" + name + "\"\n"); }

  void startServer(const std::vector<std::string>& options = {}) {
    setName("Den of Plato");
    std::vector<std::string> arguments{"tests/determinism/golden/levels/hexahedron.level",
                                       "--bind",
                                       "127.0.0.1",
                                       "--port",
                                       address_.substr(address_.find(':') + 1),
                                       "--announce",
                                       file_,
                                       "--announce-as",
                                       address_,
                                       "--config",
                                       config_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    server_ = std::make_unique<Process>(platonCommand("platon-server", arguments));
    server_->waitForError("announced file=");
  }

  void startBot() {
    bot_ = std::make_unique<Process>(platonCommand("platon-bot", {address_, "--count", "1", "--seconds", "60"}));
    server_->waitForError("joined");
  }

  void stopServer() {
    server_->signal(SIGTERM);
    EXPECT_EQ(server_->wait(), 0) << server_->errors();
  }

  bool isInFile(const std::string& text) const { return readText(file_).find(text) != std::string::npos; }

  ProcessResult list() const {
    return runProcess(platonCommand("platon-client", {"--list", "--list-url", web_.url("/servers.json")}));
  }

  // The client waits a second for answers, in which a busy machine may give none: then it is started again.
  ProcessResult listOfSome() const {
    ProcessResult result;
    EXPECT_TRUE(waitUntil([&] {
      result = list();
      return !result.output.empty();
    }));
    return result;
  }

  const TemporaryFolder folder_;
  const std::string file_ = folder_ / "servers.json";
  const std::string config_ = folder_ / "server.toml";
  const std::string address_ = freeAddress();
  const WebServer web_{[this](std::string_view) { return WebServer::ok(readText(file_)); }};
  std::unique_ptr<Process> server_;
  std::unique_ptr<Process> bot_;
};

TEST_F(AnnounceProgramTest, AServerIsListedUnderItsNameUntilItDrains) {
  startServer({"--drain", "600"});
  const ProcessResult first = listOfSome();
  EXPECT_EQ(first.exitCode, 0);
  EXPECT_EQ(first.errors, "");
  EXPECT_THAT(first.output, StartsWith(address_ + " "));
  EXPECT_THAT(first.output, HasSubstr("0/16 players"));
  EXPECT_THAT(first.output, HasSubstr(" Den of Plato\n"));

  setName("Cave");
  server_->signal(SIGHUP);
  EXPECT_TRUE(waitUntil([this] { return isInFile("Cave"); }));
  EXPECT_THAT(listOfSome().output, HasSubstr(" Cave\n"));

  startBot();
  server_->signal(SIGTERM);
  EXPECT_TRUE(waitUntil([this] { return !isInFile(address_); })) << "it drains, and still runs";
  const ProcessResult last = list();
  EXPECT_EQ(last.exitCode, 0);
  EXPECT_EQ(last.output, "");
  EXPECT_EQ(last.errors, "platon-client: no server in the list answers\n");
  stopServer();
}

TEST_F(AnnounceProgramTest, AServerThatStopsIsNotListed) {
  startServer();
  EXPECT_TRUE(isInFile(address_));
  stopServer();
  EXPECT_FALSE(isInFile(address_));
  EXPECT_TRUE(isInFile("platonServers"));
}

TEST_F(AnnounceProgramTest, WhatIsLeftOutOfAListIsToldWithExitCode1) {
  writeText(file_, "<html>");
  const ProcessResult none = list();
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_EQ(none.output, "");
  EXPECT_THAT(none.errors, StartsWith("platon-client: cannot read the list of servers at " + web_.url()));

  std::filesystem::remove(file_);
  startServer();
  std::string text = readText(file_);
  writeText(file_, text.insert(text.find('{', 1), "{\"address\": \"a.example:1\"}, "));
  const ProcessResult some = listOfSome();
  EXPECT_EQ(some.exitCode, 1);
  EXPECT_THAT(some.output, StartsWith(address_ + " "));
  EXPECT_EQ(some.errors, "platon-client: server 1 of the list: \"name\" must be a string\n");
}

TEST_F(AnnounceProgramTest, ALockThatAnotherProgramKeepsHoldsUpNoTick) {
  startServer();
  EnetClient ann(parseServerAddress(address_).port, FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
  const auto plays = [&ann](std::uint32_t ticks) {
    const std::uint32_t end = ann.fake().confirmed() + ticks;
    return stepUntil([&ann] { ann.step(); }, [&ann, end] { return ann.fake().confirmed() >= end; });
  };
  ASSERT_TRUE(plays(10));
  const Descriptor lock(open((file_ + ".lock").c_str(), O_RDWR | O_CLOEXEC));
  ASSERT_EQ(flock(lock.number(), LOCK_EX), 0);
  setName("Cave");
  server_->signal(SIGHUP);
  server_->waitForError("configuration and levels reloaded");
  EXPECT_TRUE(plays(60));
  EXPECT_THAT(server_->errors(), Not(HasSubstr("not announced"))) << "it still waits for the lock, for 3 s";
  server_->waitForError("not announced file=");
  EXPECT_THAT(server_->errors(), HasSubstr("reason=\"another program holds the lock on"));
  stopServer();
  EXPECT_THAT(server_->errors(), HasSubstr("not taken out of the list of servers"));
}

}  // namespace
}  // namespace platon::announce_program_test
