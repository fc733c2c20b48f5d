#include <gtest/gtest.h>
#include <signal.h>

#include "tests/support/enet_client.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon {
namespace {

/// A level file for one test.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() { write(farGoalText()); }

  void write(const std::string& text) const { writeText(level_, text); }
  static std::string lastLine(Process& server) {
    std::string last;
    for (std::string next = server.nextErrorLine(); !next.empty(); next = server.nextErrorLine()) last = next;
    return last;
  }
  static std::uint16_t portOf(const std::string& line) {
    return static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  }

  const TemporaryFolder folder_;
  const std::string level_ = folder_ / "test.level";
};

TEST_F(ProgramTest, ListensAndTellsTheClientsWhenStopped) {
  for (const int number : {SIGTERM, SIGINT}) {
    Process server(platonCommand("platon-server", {level_, "--port", "0", "--bind", "127.0.0.1"}));
    const std::string line = server.nextErrorLine();
    ASSERT_TRUE(line.starts_with("listening on 127.0.0.1:")) << line;
    EnetClient ann(portOf(line), FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
    const auto step = [&ann] { ann.step(); };
    EXPECT_TRUE(stepUntil(step, [&ann] { return ann.fake().confirmed() >= 10; }));
    server.signal(number);
    EXPECT_TRUE(stepUntil(step, [&ann] { return ann.fake().bye().has_value(); }));
    EXPECT_EQ(server.wait(), 0);
    EXPECT_TRUE(lastLine(server).starts_with("tick times ticks="));
  }
}

TEST_F(ProgramTest, ReloadsLevelsOnHangUp) {
  Process server(platonCommand("platon-server", {level_, "--port", "0", "--bind", "127.0.0.1"}));
  server.nextErrorLine();
  EXPECT_EQ(server.nextErrorLine(), "round started level=\"\"");
  write("CUBE\n");
  server.signal(SIGHUP);
  std::string line = server.nextErrorLine();
  EXPECT_TRUE(line.starts_with(level_ + ":1:1: error: ")) << line;
  while (line.starts_with(level_)) line = server.nextErrorLine();
  EXPECT_EQ(line, "configuration and levels not reloaded");
  write(nearGoalText());
  server.signal(SIGHUP);
  EXPECT_EQ(server.nextErrorLine(), "configuration and levels reloaded");
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
}

TEST_F(ProgramTest, ExitCodesAreThoseOfTheManual) {
  const auto ends = [](const std::vector<std::string>& arguments, int code, const std::string& start) {
    Process server(platonCommand("platon-server", arguments));
    const std::string first = server.nextErrorLine();
    EXPECT_TRUE(first.starts_with(start)) << first;
    EXPECT_EQ(server.wait(), code) << first;
  };
  Process server(platonCommand("platon-server", {level_, "--port", "0", "--bind", "127.0.0.1"}));
  const std::string port = std::to_string(portOf(server.nextErrorLine()));
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
