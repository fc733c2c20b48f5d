#include "server/admin/metrics_text.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/server/metrics_reader.h"

namespace platon::metrics_text_test {
namespace {

TEST(MetricsText, IsInTheFormatOfPrometheus) {
  const std::vector<Metric> metrics{
      {"platon_info",
       "gauge",
       "Name.",
       {{"1", {{"version", "0.1.0"}, {"name", "Our \"best\" \\server\\\nof all, Zoë"}}, {}}}},
      {"platon_tick_seconds",
       "summary",
       "Ticks.",
       {{secondsText(99), {{"quantile", "0.5"}}, {}},
        {secondsText(3'600'000'001), {}, "_sum"},
        {"1000", {}, "_count"}}},
      {"platon_sent_bytes_total", "counter", "Bytes.", {{"18446744073709551615", {}, {}}}}};
  const MetricsReader text(formatMetrics(metrics));
  EXPECT_EQ(text.types,
            (std::map<std::string, std::string>{
                {"platon_info", "gauge"}, {"platon_tick_seconds", "summary"}, {"platon_sent_bytes_total", "counter"}}));
  EXPECT_EQ(text.helps.at("platon_info"), "Name.");
  EXPECT_EQ(text.values, (std::map<std::string, std::string>{
                             {R"(platon_info{version="0.1.0",name="Our \"best\" \\server\\\nof all, Zoë"})", "1"},
                             {R"(platon_tick_seconds{quantile="0.5"})", "0.000099"},
                             {"platon_tick_seconds_sum", "3600.000001"},
                             {"platon_tick_seconds_count", "1000"},
                             {"platon_sent_bytes_total", "18446744073709551615"}}));
}

TEST(MetricsText, SecondsAreExact) {
  EXPECT_EQ(secondsText(0), "0.000000");
  EXPECT_EQ(secondsText(1'234'567), "1.234567");
  EXPECT_EQ(secondsText(18'446'744'073'709'551'615u), "18446744073709.551615");
}

}  // namespace
}  // namespace platon::metrics_text_test
