// The program platon-server while it drains.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "protocol/to_server.h"
#include "tests/net/support/enet_client.h"
#include "tests/net/support/server_fixture.h"
#include "tests/support/wait_until.h"

namespace platon::drain_program_test {
namespace {

std::uint16_t portOf(const std::string& address) {
  return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

/// A server with a player, that may drain.
class DrainingTest : public ServerTest {
 protected:
  void start(const std::vector<std::string>& options) {
    startServer(options);
    ann_.emplace(portOf(address()), FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
    EXPECT_TRUE(stepUntil(step_, [this] { return ann_->fake().confirmed() >= 10; }));
  }

  std::optional<EnetClient> ann_;
  const std::function<void()> step_ = [this] { ann_->step(); };
};

TEST_F(DrainingTest, ADrainingServerRefusesNewPlayersAndStopsWhenThePlayersHaveLeft) {
  start({"--drain", "600", "--drain-to", "play.example.org:7777"});
  server().signal(SIGTERM);
  server().waitForError("draining seconds=600 next=\"play.example.org:7777\"");
  const ProcessResult bot = runProcess(platonCommand("platon-bot", {address(), "--count", "1", "--seconds", "3"}));
  EXPECT_EQ(bot.exitCode, 1);
  EXPECT_NE(bot.errors.find("the server is about to stop; go on at play.example.org:7777"), std::string::npos)
      << bot.errors;
  EXPECT_FALSE(ann_->fake().bye());
  ann_->sendRaw(encode(Leave{}), true);
  EXPECT_TRUE(stepUntil(step_, [this] { return ann_->disconnected(); }));
  server().waitForError("drained cause=\"no players\"");
  EXPECT_EQ(server().wait(), 0);
}

TEST_F(DrainingTest, ADrainEndsAtItsLimit) {
  start({"--drain", "1"});
  server().signal(SIGTERM);
  EXPECT_TRUE(stepUntil(step_, [this] { return ann_->fake().bye().has_value(); }));
  EXPECT_EQ(*ann_->fake().bye(), (Bye{ByeCode::kServerStops, "the server stops"}));
  server().waitForError("drained cause=\"time\"");
  EXPECT_EQ(server().wait(), 0);
}

TEST_F(DrainingTest, TheSecondSignalStopsADrainingServerAtOnce) {
  start({"--drain", "600"});
  server().signal(SIGTERM);
  server().waitForError("draining seconds=600");
  server().signal(SIGTERM);
  EXPECT_TRUE(stepUntil(step_, [this] { return ann_->fake().bye().has_value(); }));
  EXPECT_EQ(server().wait(), 0);
}

TEST_F(DrainingTest, AnInterruptStopsAtOnce) {
  start({"--drain", "600"});
  server().signal(SIGINT);
  EXPECT_TRUE(stepUntil(step_, [this] { return ann_->fake().bye().has_value(); }));
  EXPECT_EQ(server().wait(), 0);
}

}  // namespace
}  // namespace platon::drain_program_test
