#include "server/admin/metrics_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/files.h"

namespace platon::metrics_text_test {
namespace {

Metrics sample() {
  Metrics metrics;
  metrics.startedAt = UtcTime(std::chrono::seconds(1'795'800'000));
  metrics.version = "0.1.0";
  metrics.serverName = "Our \"best\" \\server\\\nof all, Zoë";
  metrics.connectedPlayers = 3;
  metrics.disconnectedPlayers = 1;
  metrics.maxPlayers = 16;
  metrics.bans = 2;
  metrics.tickCount = 1000;
  metrics.tickSumUs = 3'600'000'001;
  metrics.tickP50Us = 99;
  metrics.tickP99Us = 1'234'567;
  metrics.tickMaxUs = 2'000'000;
  metrics.receivedBytes = 18'446'744'073'709'551'615u;
  metrics.sentBytes = 5;
  metrics.missedInputs = 6;
  metrics.desyncs = 7;
  metrics.drops = {{"invalid_datagram", 8}, {"expired", 0}};
  metrics.droppedTicks = 9;
  metrics.stoppedRecordings = 10;
  metrics.unwrittenBans = 11;
  metrics.unwrittenBestTimes = 12;
  return metrics;
}

/// Reads the text format of Prometheus, version 0.0.4, as its description says, and shares no code with the formatter:
/// https://prometheus.io/docs/instrumenting/exposition_formats/#text-format-details
class TextFormat {
 public:
  explicit TextFormat(const std::string& text) {
    EXPECT_TRUE(text.empty() || text.back() == '\n') << "the last line must end with a line feed";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) read(line);
    for (const auto& [name, type] : types) EXPECT_TRUE(helps.contains(name)) << name;
  }

  std::map<std::string, std::string> types;   // by name of the metric
  std::map<std::string, std::string> helps;   // by name of the metric
  std::map<std::string, std::string> values;  // by name and labels, as they stand there

 private:
  void read(const std::string& line) {
    static const std::regex help("# HELP ([a-zA-Z_:][a-zA-Z0-9_:]*) ((?:[^\\\\\\n]|\\\\\\\\|\\\\n)*)");
    static const std::regex type("# TYPE ([a-zA-Z_:][a-zA-Z0-9_:]*) (counter|gauge|histogram|summary|untyped)");
    static const std::regex sampleLine(
        "(([a-zA-Z_:][a-zA-Z0-9_:]*)(?:\\{([a-zA-Z_][a-zA-Z0-9_]*=\"(?:[^\"\\\\\\n]|\\\\\\\\|\\\\\"|\\\\n)*\""
        "(?:,[a-zA-Z_][a-zA-Z0-9_]*=\"(?:[^\"\\\\\\n]|\\\\\\\\|\\\\\"|\\\\n)*\")*)\\})?) ([0-9]+(?:\\.[0-9]+)?)");
    std::smatch match;
    if (std::regex_match(line, match, help)) {
      EXPECT_TRUE(helps.emplace(match[1], match[2]).second) << "second HELP of " << match[1];
      begin(match[1]);
    } else if (std::regex_match(line, match, type)) {
      EXPECT_TRUE(types.emplace(match[1], match[2]).second) << "second TYPE of " << match[1];
      EXPECT_EQ(current_, match[1]) << "TYPE outside its group";
      EXPECT_FALSE(hasSample_) << "TYPE after a sample of " << match[1];
    } else if (std::regex_match(line, match, sampleLine)) {
      EXPECT_EQ(metricOf(match[2]), current_) << "the lines of a metric must form one group";
      EXPECT_TRUE(values.emplace(match[1], match[4]).second) << "second sample of " << match[1];
      hasSample_ = true;
    } else {
      ADD_FAILURE() << "not a line of the format: " << line;
    }
  }

  void begin(const std::string& name) {
    EXPECT_TRUE(begun_.insert(name).second) << "second group of " << name;
    current_ = name;
    hasSample_ = false;
  }

  // Samples of a summary may have the suffixes _sum and _count.
  std::string metricOf(const std::string& sampleName) const {
    for (const std::string suffix : {"_sum", "_count"}) {
      const std::string base = sampleName.substr(0, sampleName.size() - std::min(sampleName.size(), suffix.size()));
      const auto found = types.find(base);
      if (sampleName.ends_with(suffix) && found != types.end() && found->second == "summary") return base;
    }
    return sampleName;
  }

  std::string current_;
  bool hasSample_ = false;
  std::set<std::string> begun_;
};

TEST(MetricsText, FollowsTheRulesOfTheFormat) {
  const TextFormat text(formatMetrics(sample()));
  EXPECT_EQ(text.values.size(), 21u);
  for (const auto& [name, type] : text.types) {
    EXPECT_EQ(type == "counter", name.ends_with("_total")) << name;
    EXPECT_TRUE(name.starts_with("platon_") || name == "process_start_time_seconds") << name;
  }
}

TEST(MetricsText, HasEveryValue) {
  const TextFormat text(formatMetrics(sample()));
  const std::map<std::string, std::string> expected{
      {"process_start_time_seconds", "1795800000"},
      {R"(platon_info{version="0.1.0",name="Our \"best\" \\server\\\nof all, Zoë"})", "1"},
      {R"(platon_players{state="connected"})", "3"},
      {R"(platon_players{state="disconnected"})", "1"},
      {"platon_players_limit", "16"},
      {"platon_bans", "2"},
      {R"(platon_tick_seconds{quantile="0.5"})", "0.000099"},
      {R"(platon_tick_seconds{quantile="0.99"})", "1.234567"},
      {"platon_tick_seconds_sum", "3600.000001"},
      {"platon_tick_seconds_count", "1000"},
      {"platon_tick_max_seconds", "2.000000"},
      {"platon_dropped_ticks_total", "9"},
      {"platon_received_bytes_total", "18446744073709551615"},
      {"platon_sent_bytes_total", "5"},
      {"platon_missed_inputs_total", "6"},
      {"platon_desyncs_total", "7"},
      {R"(platon_drops_total{reason="invalid_datagram"})", "8"},
      {R"(platon_drops_total{reason="expired"})", "0"},
      {"platon_stopped_recordings_total", "10"},
      {"platon_unwritten_bans_total", "11"},
      {"platon_unwritten_best_times_total", "12"}};
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(text.values.contains(name)) << name;
    EXPECT_EQ(text.values.at(name), value) << name;
  }
  EXPECT_EQ(text.values.size(), expected.size());
}

TEST(MetricsText, HasTheTrafficFromTheStart) {
  const TextFormat text(formatMetrics(Metrics()));
  EXPECT_EQ(text.values.at("platon_received_bytes_total"), "0");
  EXPECT_EQ(text.values.at("platon_sent_bytes_total"), "0");
}

TEST(HostingPage, ListsEveryMetricWithItsType) {
  const std::string page = readText("docs/hosting.md");
  const TextFormat text(formatMetrics(sample()));
  for (const auto& [name, type] : text.types) {
    const std::string row = std::string("| `").append(name).append("` | ").append(type).append(" | ");
    EXPECT_NE(page.find(row), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace platon::metrics_text_test
