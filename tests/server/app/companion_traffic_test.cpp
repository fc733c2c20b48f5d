// What several players of one connection send, through a whole server in virtual time.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "client/net/enet_link.h"
#include "server/app/dedicated_server.h"
#include "tests/net/support/datagram_network.h"
#include "tests/net/support/fake_client.h"
#include "tests/support/test_levels.h"

namespace platon::companion_traffic_test {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kSeconds = 10;

/// Sends a message in every tick, as a client does while buttons change.
class CompanionTraffic : public testing::Test {
 protected:
  // Four players whose messages carry the inputs of so many ticks, and who change a button every `interval` ticks.
  void play(std::uint32_t ticks, std::uint32_t interval) {
    const auto buttons = [interval](std::uint32_t local) {
      return [=](std::uint32_t tick) { return static_cast<int>((tick + local) / interval % 2 + 1); };
    };
    client_.emplace("A", ticks - 1, buttons(0));
    for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local) client_->addCompanion(local, "P", buttons(local));
    run(2 * kTicksPerSecond);
    network_.forgetSent();
    const std::uint32_t before = client_->confirmed();
    run(kSeconds * kTicksPerSecond);
    EXPECT_GE(client_->confirmed() - before + 2, kSeconds * kTicksPerSecond);
  }

  void run(std::uint32_t ticks) {
    for (; ticks > 0; --ticks) {
      now_ += std::chrono::microseconds(16667);
      exchange(timeOf(now_));
      server_.step(now_);
    }
  }

  void exchange(Time now) {
    connection_.service(now, [&](std::span<const std::uint8_t> bytes) {
      client_->receive({bytes.begin(), bytes.end()}, now);
    });
    if (connection_.state() != EnetLink::State::kConnected) return;
    client_->update(now);
    for (const OutgoingMessage& message : client_->takeOutgoing()) connection_.send(message.bytes, message.reliable);
    connection_.flush(now);
  }

  std::size_t bytesPerSecond() const { return network_.bytesTo(kServer) / kSeconds; }
  std::uint64_t excess() { return server_.host().rejections().excess; }

  static inline const SocketAddress kServer = addressAt("198.51.100.1", 7777);
  static inline const SocketAddress kOwn = addressAt("192.0.2.1", 5000);

  DatagramNetwork network_;
  DedicatedServer server_{
      network_.socket(kServer), {}, {levelOf(farGoalText())}, {LogFormat::kText, [](std::string_view) {}}};
  TimePoint now_{std::chrono::hours(1)};
  EnetLink connection_{network_.socket(kOwn), {kServer}, {}};
  std::optional<FakeClient> client_;
};

// docs/security.md has the numbers.
TEST_F(CompanionTraffic, FourWhoPressTenKeysASecondEachAreWithinTheBudgetAtARoundTripOfTwoSeconds) {
  play(180, 6);
  EXPECT_EQ(excess(), 0u);
  EXPECT_EQ(server_.match().players(), 4u);
  EXPECT_EQ(server_.match().missedInputs(), 0u);
  EXPECT_GT(bytesPerSecond(), 16'000u);
  EXPECT_LT(bytesPerSecond(), 20'000u);
}

TEST_F(CompanionTraffic, FourWhoseInputsChangeInEveryTickAreWithinTheBudgetAtARoundTripOfOneSecond) {
  play(75, 1);
  EXPECT_EQ(excess(), 0u);
  EXPECT_EQ(server_.match().missedInputs(), 0u);
  EXPECT_LT(bytesPerSecond(), 24'000u);
}

TEST_F(CompanionTraffic, ALongMessageOfFourPlayersFitsADatagram) {
  play(kMaxInputsPerMessage, 1);
  EXPECT_GT(network_.sent().size(), 0u);
  for (const DatagramNetwork::Sent& sent : network_.sent()) ASSERT_LE(sent.bytes.size(), kMaxDatagramBytes);
  EXPECT_EQ(server_.match().players(), 4u) << "what exceeds the budget is dropped, and the connection stays";
  EXPECT_GT(excess(), 0u);
}

}  // namespace
}  // namespace platon::companion_traffic_test
