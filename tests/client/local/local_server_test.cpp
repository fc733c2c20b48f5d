#include "client/local/local_server.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/session/network_client.h"
#include "tests/support/test_levels.h"

namespace platon::local_server_test {
namespace {

using std::chrono::microseconds;

constexpr Time kTick = microseconds(16'667);
constexpr Time kLong = std::chrono::hours(1);

Controls pressing(std::uint8_t buttons) {
  return [buttons](const Game&, std::uint32_t) { return Input{buttons}; };
}

class LocalServerTest : public testing::Test {
 protected:
  // As long as `ticks` take, in frames of one tick.
  void play(int ticks, std::uint8_t buttons = 0) {
    for (int i = 0; i < ticks; ++i) {
      now_ += kTick;
      server_.update(now_);
      for (NetworkClient* const client : clients_) client->update(now_, pressing(buttons));
      server_.update(now_);
    }
  }
  static const Prediction& predictionOf(const NetworkClient& client) { return client.session()->round()->prediction(); }

  Time now_ = std::chrono::seconds(1000);
  LocalServer server_{{.maxPlayers = 4, .serverName = "Test"}, {levelOf(farGoalText())}, nullptr, now_};
  std::vector<NetworkClient*> clients_;
};

TEST_F(LocalServerTest, AClientPlaysInTheSecondFrame) {
  NetworkClient client(server_.links(), {"Ann"}, now_);
  clients_ = {&client};
  play(3);
  ASSERT_TRUE(client.welcomed());
  ASSERT_NE(client.session()->round(), nullptr);
  EXPECT_EQ(server_.match().clients(), 1U);
  const std::uint32_t before = predictionOf(client).confirmedTicks();
  play(60);
  EXPECT_EQ(predictionOf(client).confirmedTicks() - before, 60U);
  EXPECT_EQ(client.traffic().sentBytes, 0U) << "nothing leaves the program";
  EXPECT_EQ(client.identity(), std::nullopt);
}

TEST_F(LocalServerTest, NoInputIsTooLateAndNothingIsCorrected) {
  NetworkClient client(server_.links(), {"Ann"}, now_);
  clients_ = {&client};
  play(120);
  for (int i = 0; i < 30; ++i) play(1 + i % 7, i % 2 == 0 ? Input::kRight : Input::kLeft | Input::kJump);
  EXPECT_EQ(server_.match().missedInputs(), 0U);
  EXPECT_EQ(client.session()->predictionStatistics().corrections, 0U);
  EXPECT_EQ(client.session()->roundStatistics().desyncs, 0U);
}

TEST_F(LocalServerTest, NoTickPassesWhileItsTimeStandsStill) {
  NetworkClient client(server_.links(), {"Ann"}, now_);
  clients_ = {&client};
  play(30);
  const std::uint64_t hash = server_.match().game().hash();
  for (int i = 0; i < 1000; ++i) {
    server_.update(now_);
    client.update(now_, pressing(Input::kRight));
  }
  EXPECT_EQ(server_.match().game().hash(), hash);
}

TEST_F(LocalServerTest, AfterALongPauseTheGameGoesOnWhereItWas) {
  NetworkClient client(server_.links(), {"Ann"}, now_);
  clients_ = {&client};
  play(30);
  const std::uint32_t before = server_.match().game().tick();
  now_ += kLong;
  play(1);
  EXPECT_LE(server_.match().game().tick() - before, 17U) << "a quarter of a second";
  play(60);
  EXPECT_FALSE(client.outage());
  EXPECT_EQ(client.session()->roundStatistics().desyncs, 0U);
}

TEST_F(LocalServerTest, WhoLeavesIsToldSoAndItsPlaceIsFree) {
  NetworkClient client(server_.links(), {"Ann"}, now_);
  NetworkClient other(server_.links(), {"Ben"}, now_);
  clients_ = {&client, &other};
  play(30);
  ASSERT_EQ(server_.match().players(), 2U);
  EXPECT_EQ(predictionOf(client).confirmed().presentPlayers(), 2U);
  client.leave();
  play(2);
  EXPECT_TRUE(client.closed());
  EXPECT_EQ(server_.match().allPlayers(), 1U);
  play(10);
  EXPECT_EQ(predictionOf(other).confirmed().presentPlayers(), 1U);
}

TEST_F(LocalServerTest, AClientThatIsGoneHoldsItsButtonsNoLonger) {
  {
    NetworkClient client(server_.links(), {"Ann"}, now_);
    clients_ = {&client};
    play(30, Input::kRight);
    ASSERT_EQ(server_.match().clients(), 1U);
    clients_.clear();
  }
  play(1);
  EXPECT_EQ(server_.match().clients(), 0U);
}

TEST_F(LocalServerTest, TheLastMessageComesBeforeTheEnd) {
  NetworkClient client(server_.links(), {"Ann"}, now_);
  clients_ = {&client};
  play(30);
  EXPECT_TRUE(server_.match().kick(0, "too loud"));
  play(2);
  EXPECT_EQ(client.ending(), "the server ended the game: too loud");
  EXPECT_TRUE(client.closed());
}

}  // namespace
}  // namespace platon::local_server_test
