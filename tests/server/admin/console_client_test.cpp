#include "server/admin/console_client.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include "server/admin/console_server.h"
#include "tests/support/temporary_folder.h"

namespace platon::console_client_test {
namespace {

/// A server in a thread of its own that replies with the line; lines that begin with "no" fail, and "end" ends it.
class RunningServer {
 public:
  explicit RunningServer(const std::string& path) : server_(path), thread_([this] { run(); }) {}
  ~RunningServer() {
    stop_ = true;
    thread_.join();
  }

 private:
  void run() {
    while (!stop_) {
      server_->poll(std::chrono::steady_clock::now(), [this](std::string_view line) {
        if (line == "end") stop_ = true;
        return ConsoleReply{!line.starts_with("no"), "> " + std::string(line)};
      });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    server_.reset();
  }

  std::optional<ConsoleServer> server_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: uses the members above from its start
};

class ConsoleClientTest : public testing::Test {
 protected:
  int run(const std::string& commands, bool interactive = false) {
    std::istringstream in(commands);
    return runConsole(path_, {in, results_, talk_, interactive});
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  const std::string path_ = folder_ / "console.sock";
  std::ostringstream results_, talk_;
};

TEST_F(ConsoleClientTest, ExecutesOneCommandALine) {
  const RunningServer server(path_);
  EXPECT_EQ(run("a\n b\n"), 0);
  EXPECT_EQ(results_.str(), "> a\n>  b\n");
  EXPECT_EQ(talk_.str(), "");
}

TEST_F(ConsoleClientTest, SkipsEmptyLinesAndComments) {
  const RunningServer server(path_);
  EXPECT_EQ(run("\n# a\n  \n  # b\na"), 0);
  EXPECT_EQ(results_.str(), "> a\n");
}

TEST_F(ConsoleClientTest, AFailedCommandIsReportedAndDoesNotEndTheOthers) {
  const RunningServer server(path_);
  EXPECT_EQ(run("no1\na\nno2\n"), 1);
  EXPECT_EQ(results_.str(), "> a\n");
  EXPECT_EQ(talk_.str(), "error: > no1\nerror: > no2\n");
}

TEST_F(ConsoleClientTest, QuitEndsTheConsole) {
  const RunningServer server(path_);
  EXPECT_EQ(run("a\nquit \nno\n"), 0);
  EXPECT_EQ(run("exit\nno\n"), 0);
  EXPECT_EQ(results_.str(), "> a\n");
}

TEST_F(ConsoleClientTest, APersonGetsAPrompt) {
  const RunningServer server(path_);
  EXPECT_EQ(run("a\n", true), 0);
  EXPECT_EQ(talk_.str(), "platon> platon> ");
}

TEST_F(ConsoleClientTest, ALineThatTheServerRefusesEndsTheConsole) {
  const RunningServer server(path_);
  EXPECT_EQ(run(std::string(1000, 'x') + "\na\n"), 1);
  EXPECT_TRUE(talk_.str().starts_with("error: a command has at most 512 bytes; the console is closed\n"))
      << talk_.str();
}

TEST_F(ConsoleClientTest, SaysThatNoServerAnswers) {
  EXPECT_EQ(run("a\n"), 1);
  EXPECT_EQ(talk_.str(), "platon-server: no server answers at '" + path_ +
                             "' (No such file or directory); start one, or name its socket after --socket\n");
}

TEST_F(ConsoleClientTest, SaysThatTheServerHasEnded) {
  const RunningServer server(path_);
  EXPECT_EQ(run("end\na\n"), 1);
  EXPECT_EQ(results_.str(), "> end\n");
  EXPECT_EQ(talk_.str(), "platon-server: the server at '" + path_ + "' has ended or does not answer\n");
}

// A user of this machine other than root.
constexpr uid_t kStranger = 65534;

// Makes the system take this program for one of another user, as long as it lives. Only root can.
class ActingAs {
 public:
  explicit ActingAs(uid_t user) { EXPECT_EQ(seteuid(user), 0); }
  ~ActingAs() { EXPECT_EQ(seteuid(0), 0); }
  ActingAs(const ActingAs&) = delete;
  ActingAs& operator=(const ActingAs&) = delete;
};

// The server of another user, at a path that root gives to its console.
class StrangersServerTest : public ConsoleClientTest {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root may act as another user";
    ASSERT_EQ(chown(folder_.path().c_str(), kStranger, kStranger), 0);
    const ActingAs stranger(kStranger);
    server_.emplace(path_);
  }

  // What the console says if the folder has an owner and rights.
  int runIn(uid_t owner, mode_t rights) {
    EXPECT_EQ(chown(folder_.path().c_str(), owner, 0), 0);
    EXPECT_EQ(chmod(folder_.path().c_str(), rights), 0);
    return run("a\n");
  }

  std::optional<RunningServer> server_;
  const std::string refusal_ =
      "platon-server: the server at '" + path_ +
      "' belongs to another user; name the socket of your own after --socket, or run the console as that user\n";
};

// It was told that no server answers, and to start one.
TEST_F(StrangersServerTest, AnotherUserIsToldWhoMayOpenIt) {
  ASSERT_EQ(chmod(folder_.path().c_str(), 0755), 0);
  ASSERT_EQ(chmod(path_.c_str(), 0600), 0);
  const ActingAs other(kStranger - 1);
  EXPECT_EQ(run("a\n"), 1);
  EXPECT_EQ(
      talk_.str(),
      "platon-server: no server answers at '" + path_ +
          "' (Permission denied); this user may not open it; run the console as the user of the server, or as root\n");
}

TEST_F(StrangersServerTest, RootTellsItNothingWhereOthersCanMakeASocket) {
  for (const auto& [owner, rights] :
       {std::pair(0u, 01777u), std::pair(0u, 0755u), std::pair(kStranger, 0757u), std::pair(kStranger, 0775u)}) {
    EXPECT_EQ(runIn(owner, rights), 1);
    EXPECT_EQ(talk_.str(), refusal_) << owner << " " << rights;
    talk_.str("");
  }
  EXPECT_EQ(results_.str(), "");
}

TEST_F(StrangersServerTest, RootControlsItInAFolderOfItsOwn) {
  EXPECT_EQ(runIn(kStranger, 0755), 0);
  EXPECT_EQ(results_.str(), "> a\n");
  EXPECT_EQ(talk_.str(), "");
}

TEST_F(StrangersServerTest, AnotherUserTellsItNothing) {
  EXPECT_EQ(chmod(path_.c_str(), 0666), 0);
  EXPECT_EQ(chmod(folder_.path().c_str(), 0755), 0);
  {
    const ActingAs another(kStranger - 1);
    EXPECT_EQ(run("a\n"), 1);
  }
  EXPECT_EQ(talk_.str(), refusal_);
}

}  // namespace
}  // namespace platon::console_client_test
