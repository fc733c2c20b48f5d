#include "server/app/log.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::log_test {
namespace {

TEST(Log, WritesOneLinePerEvent) {
  std::vector<std::string> lines;
  Log log(LogFormat::kText, [&lines](std::string_view line) { lines.emplace_back(line); });
  log.info("listening on 0.0.0.0:7777");
  log.warning("joined", {{"slot", std::uint64_t{3}}, {"name", std::string("a\"b")}});
  EXPECT_EQ(lines, (std::vector<std::string>{"listening on 0.0.0.0:7777", "joined slot=3 name=\"a\\\"b\""}));
}

TEST(Log, WritesJsonWithTheTime) {
  std::string line;
  Log log(LogFormat::kJson, [&line](std::string_view text) { line = text; });
  log.warning("kept \"out\"", {{"count", std::uint64_t{3}}, {"name", std::string("a\nb\\")}});
  const std::string time = R"({"time":")";
  ASSERT_EQ(line.substr(0, time.size()), time);
  EXPECT_EQ(line.substr(time.size() + std::string("2024-01-01T00:00:00.000Z").size()),
            R"(","level":"warning","message":"kept \"out\"","count":3,"name":"a\u000ab\\"})");
}

}  // namespace
}  // namespace platon::log_test
