#include "server/program/server_metrics.h"

#include <map>

#include <gtest/gtest.h>

#include "platon_version.h"
#include "tests/net/support/enet_client.h"
#include "tests/net/support/raw_socket.h"
#include "tests/server/metrics_reader.h"
#include "tests/support/files.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::server_metrics_test {
namespace {

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

  MetricsReader metrics() const { return MetricsReader(formatMetrics(metricsOf(server_, facts_))); }
  std::string value(const std::string& name) const { return metrics().values.at(name); }
  std::string drops(const std::string& reason) const { return value("platon_drops_total{reason=\"" + reason + "\"}"); }

  ProgramFacts facts_{.startedAt = UtcTime(std::chrono::seconds(1'795'800'000)),
                      .serverName = "Lobby",
                      .maxPlayers = 16,
                      .bans = 2,
                      .unwrittenBans = 11};
  DedicatedServer server_{settings(), {levelOf(farGoalText())}, Log(LogFormat::kText, [](std::string_view) {})};
};

TEST_F(ServerMetricsTest, AServerThatHasJustStartedHasCountedNothing) {
  // A new fact needs a row below.
  [[maybe_unused]] const auto& [startedAt, serverName, maxPlayers, bans, unwrittenBans] = facts_;
  std::map<std::string, std::string> values = metrics().values;
  const std::map<std::string, std::string> known{
      {"process_start_time_seconds", "1795800000"},
      {"platon_info{version=\"" + std::string(kVersion) + "\",name=\"Lobby\"}", "1"},
      {"platon_players_limit", "16"},
      {"platon_bans", "2"},
      {"platon_unwritten_bans_total", "11"}};
  for (const auto& [name, value] : known) {
    EXPECT_EQ(values[name], value) << name;
    values.erase(name);
  }
  for (const auto& [name, value] : values) EXPECT_TRUE(value == "0" || value == "0.000000") << name << " " << value;
}

TEST_F(ServerMetricsTest, ReportsPlayersTicksAndDesyncs) {
  EnetClient ann(server_.port(), FakeClient("Ann", 10, [](std::uint32_t) { return 0; }));
  EXPECT_TRUE(run(ann, [&] { return ann.fake().confirmed() >= 20; }));
  ann.fake().corruptGame();
  EXPECT_TRUE(run(ann, [&] { return value("platon_desyncs_total") == "1"; }));
  EXPECT_EQ(value("platon_players{state=\"connected\"}"), "1");
  EXPECT_EQ(value("platon_players{state=\"disconnected\"}"), "0");
  EXPECT_EQ(value("platon_tick_seconds_count"), std::to_string(server_.tickTimes().count()));
  EXPECT_EQ(value("platon_tick_seconds_sum"), secondsText(server_.tickTimes().sum()));
  EXPECT_EQ(value("platon_tick_seconds{quantile=\"0.5\"}"), secondsText(server_.recentTickTimes().quantile(0.5)));
  EXPECT_EQ(value("platon_tick_seconds{quantile=\"0.99\"}"), secondsText(server_.recentTickTimes().quantile(0.99)));
  EXPECT_EQ(value("platon_tick_max_seconds"), secondsText(server_.tickTimes().longest()));
  EXPECT_EQ(value("platon_missed_inputs_total"), std::to_string(server_.match().missedInputs()));
  EXPECT_NE(value("platon_received_bytes_total"), "0");
  EXPECT_NE(value("platon_sent_bytes_total"), "0");
}

TEST_F(ServerMetricsTest, ReportsWhatIsDroppedByReason) {
  EnetClient eve(server_.port(), FakeClient("Eve", 10, [](std::uint32_t) { return 0; }));
  EXPECT_TRUE(run(eve, [&] { return server_.match().players() == 1; }));
  const RawSocket attacker(server_.address());
  attacker.send(Bytes{0});
  EXPECT_TRUE(run(eve, [&] { return drops("malformed") == "1"; }));
  eve.sendRaw({1, 2, 3, 4, 5, 6, 7, 8}, true);
  EXPECT_TRUE(run(eve, [&] { return drops("message") == "1"; }));
  EXPECT_EQ(drops("banned"), "0");
  EXPECT_EQ(drops("handshakes"), "0");
}

TEST_F(ServerMetricsTest, NamesAndTypesFollowTheCustomsOfPrometheus) {
  for (const auto& [name, type] : metrics().types) {
    EXPECT_EQ(type == "counter", name.ends_with("_total")) << name;
    EXPECT_TRUE(name.starts_with("platon_") || name == "process_start_time_seconds") << name;
  }
}

TEST_F(ServerMetricsTest, TheManualListsEveryMetricWithItsType) {
  const std::string page = readText("docs/hosting.md");
  for (const auto& [name, type] : metrics().types) {
    const std::string row = std::string("| `").append(name).append("` | ").append(type).append(" | ");
    EXPECT_NE(page.find(row), std::string::npos) << "docs/hosting.md#metrics lacks a row that begins with " << row;
  }
}

TEST_F(ServerMetricsTest, TheManualListsEveryReasonOfADrop) {
  const std::string page = readText("docs/hosting.md");
  const std::size_t begin = page.find("| `platon_drops_total`");
  const std::string row = page.substr(begin, page.find('\n', begin) - begin);
  for (const Rejection& each : server_.host().rejections().list())
    EXPECT_NE(row.find("`" + std::string(each.reason) + "`"), std::string::npos) << each.reason;
}

}  // namespace
}  // namespace platon::server_metrics_test
