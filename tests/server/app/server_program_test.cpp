#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/support/enet_client.h"
#include "tests/support/server_process.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

using namespace std::chrono_literals;

/// A level file for one test.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() { write(farGoalText()); }
  ~ProgramTest() override { std::filesystem::remove(level_); }

  void write(const std::string& text) const { std::ofstream(level_) << text; }
  static std::string lastLine(ServerProcess& server) {
    std::string last;
    for (std::string next = server.line(); !next.empty(); next = server.line()) last = next;
    return last;
  }
  static std::uint16_t portOf(const std::string& line) {
    return static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  }

  std::string level_ = testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".level";
};

TEST_F(ProgramTest, ListensAndSaysGoodByeWhenStopped) {
  for (const int number : {SIGTERM, SIGINT}) {
    ServerProcess server({level_, "--port", "0", "--bind", "127.0.0.1"});
    const std::string line = server.line();
    ASSERT_TRUE(line.starts_with("listening on 127.0.0.1:")) << line;
    EnetClient ann(portOf(line), FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
    for (int i = 0; i < 1000 && ann.fake().confirmed() < 10; ++i, std::this_thread::sleep_for(4ms)) ann.step();
    EXPECT_GE(ann.fake().confirmed(), 10u);
    server.signal(number);
    for (int i = 0; i < 500 && !ann.disconnected(); ++i, std::this_thread::sleep_for(4ms)) ann.step();
    EXPECT_TRUE(ann.fake().bye());
    EXPECT_EQ(server.wait(), 0);
    EXPECT_TRUE(lastLine(server).starts_with("ran ticks="));
  }
}

TEST_F(ProgramTest, ReadsLevelsAgainOnHangUp) {
  ServerProcess server({level_, "--port", "0", "--bind", "127.0.0.1"});
  server.line();
  EXPECT_EQ(server.line(), "round starts level=\"\"");
  write("CUBE\n");
  server.signal(SIGHUP);
  std::string line = server.line();
  EXPECT_TRUE(line.starts_with(level_ + ":1:1: error: ")) << line;
  while (line.starts_with(level_)) line = server.line();
  EXPECT_EQ(line, "configuration and levels stay as they are");
  write(nearGoalText());
  server.signal(SIGHUP);
  EXPECT_EQ(server.line(), "configuration and levels read again");
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
}

TEST_F(ProgramTest, FaultsEndItWithTheCodesOfTheManual) {
  const auto ends = [](const std::vector<std::string>& arguments, int code, const std::string& start) {
    ServerProcess server(arguments);
    const std::string first = server.line();
    EXPECT_TRUE(first.starts_with(start)) << first;
    EXPECT_EQ(server.wait(), code) << first;
  };
  ServerProcess server({level_, "--port", "0", "--bind", "127.0.0.1"});
  const std::string port = std::to_string(portOf(server.line()));
  ends({level_, "--port", port, "--bind", "127.0.0.1"}, 2,
       "platon-server: cannot listen on 127.0.0.1:" + port + ": Address already in use; ");
  ends({"--colour"}, 2, "platon-server: The following argument was not expected: --colour");
  ends({level_, "--port", "0", "--record", level_ + "/games"}, 2,
       "platon-server: cannot write recordings to '" + level_ + "/games': Not a directory; name another folder");
  ends({"/no/such.level"}, 2, "platon-server: cannot read the level '/no/such.level'");
  write("CUBE\n");
  ends({level_}, 3, level_ + ":1:1: error: ");
}

}  // namespace
}  // namespace platon
