#include "server/admin/console_client.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <sstream>
#include <thread>

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

}  // namespace
}  // namespace platon::console_client_test
