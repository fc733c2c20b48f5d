#include "server/app/server_metrics.h"

#include <gtest/gtest.h>

#include "platon_version.h"
#include "tests/support/enet_client.h"
#include "tests/support/files.h"
#include "tests/support/test_levels.h"
#include "tests/support/transport/raw_socket.h"
#include "tests/support/wait_until.h"

namespace platon::server_metrics_test {
namespace {

std::uint64_t dropsFor(const Metrics& metrics, std::string_view reason) {
  for (const Metrics::Drop& drop : metrics.drops) {
    if (drop.reason == reason) return drop.count;
  }
  ADD_FAILURE() << "no drops for " << reason;
  return 0;
}

/// A server over loopback, in real time.
class ServerMetricsTest : public testing::Test {
 protected:
  static ServerSettings settings() {
    ServerSettings settings;
    settings.bind = "127.0.0.1";
    return settings;
  }

  template <class Done>
  bool run(EnetClient& client, Done done) {
    const auto step = [&] {
      server_.step(std::chrono::steady_clock::now());
      client.step();
    };
    return stepUntil(step, done);
  }

  DedicatedServer server_{settings(), {levelOf(farGoalText())}, Log(LogFormat::kText, [](std::string_view) {})};
};

TEST_F(ServerMetricsTest, AServerThatHasJustStartedHasCountedNothing) {
  const Metrics metrics = metricsOf(server_);
  EXPECT_EQ(metrics.version, kVersion);
  EXPECT_EQ(metrics.connectedPlayers, 0u);
  EXPECT_EQ(metrics.tickCount, 0u);
  EXPECT_EQ(metrics.tickMaxUs, 0u);
  EXPECT_EQ(metrics.droppedTicks, 0u);
  EXPECT_EQ(metrics.stoppedRecordings, 0u);
  EXPECT_EQ(metrics.unwrittenBestTimes, 0u);
  for (const Metrics::Drop& drop : metrics.drops) EXPECT_EQ(drop.count, 0u) << drop.reason;
}

TEST_F(ServerMetricsTest, ReportsPlayersTicksAndDesyncs) {
  EnetClient ann(server_.port(), FakeClient("Ann", 10, [](std::uint32_t) { return 0; }));
  EXPECT_TRUE(run(ann, [&] { return ann.fake().confirmed() >= 20; }));
  ann.fake().corruptGame();
  EXPECT_TRUE(run(ann, [&] { return metricsOf(server_).desyncs == 1; }));
  const Metrics metrics = metricsOf(server_);
  EXPECT_EQ(metrics.connectedPlayers, 1u);
  EXPECT_EQ(metrics.disconnectedPlayers, 0u);
  EXPECT_EQ(metrics.tickCount, server_.tickTimes().count());
  EXPECT_EQ(metrics.tickSumUs, server_.tickTimes().sum());
  EXPECT_EQ(metrics.tickP50Us, server_.recentTickTimes().quantile(0.5));
  EXPECT_EQ(metrics.tickP99Us, server_.recentTickTimes().quantile(0.99));
  EXPECT_EQ(metrics.tickMaxUs, server_.tickTimes().longest());
  EXPECT_EQ(metrics.missedInputs, server_.match().missedInputs());
}

TEST_F(ServerMetricsTest, ReportsWhatIsDroppedByReason) {
  EnetClient eve(server_.port(), FakeClient("Eve", 10, [](std::uint32_t) { return 0; }));
  EXPECT_TRUE(run(eve, [&] { return server_.match().players() == 1; }));
  const RawSocket attacker(server_.address());
  attacker.send(Bytes{0});
  EXPECT_TRUE(run(eve, [&] { return dropsFor(metricsOf(server_), "malformed") == 1; }));
  eve.sendRaw({1, 2, 3, 4, 5, 6, 7, 8}, true);
  EXPECT_TRUE(run(eve, [&] { return dropsFor(metricsOf(server_), "message") == 1; }));
  EXPECT_EQ(dropsFor(metricsOf(server_), "banned"), 0u);
  EXPECT_EQ(dropsFor(metricsOf(server_), "handshakes"), 0u);
}

TEST_F(ServerMetricsTest, TheManualListsEveryReasonOfADrop) {
  const std::string page = readText("docs/hosting.md");
  const std::size_t begin = page.find("| `platon_drops_total`");
  const std::string row = page.substr(begin, page.find('\n', begin) - begin);
  for (const Metrics::Drop& drop : metricsOf(server_).drops) {
    EXPECT_NE(row.find("`" + std::string(drop.reason) + "`"), std::string::npos) << drop.reason;
  }
}

}  // namespace
}  // namespace platon::server_metrics_test
