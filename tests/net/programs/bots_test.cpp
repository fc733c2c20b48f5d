#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/net/support/server_fixture.h"
#include "tests/support/process.h"

namespace platon::bots_test {
namespace {

// The numbers of a flat JSON object. Fails the test if the text is not one.
std::map<std::string, double> numbersOf(const std::string& json) {
  std::map<std::string, double> numbers;
  const char* at = json.c_str();
  EXPECT_EQ(*at, '{') << json;
  while (*at == '{' || *at == ',') {
    const std::string rest(at + 1);
    const std::size_t quote = rest.find('"', 1);
    if (rest[0] != '"' || quote == std::string::npos || rest[quote + 1] != ':') break;
    char* end = nullptr;
    numbers[rest.substr(1, quote - 1)] = std::strtod(at + quote + 3, &end);
    at = end;
  }
  EXPECT_STREQ(at, "}\n") << json;
  return numbers;
}

const std::vector<std::string> kKeys = {"connected",
                                        "failed",
                                        "connectMs",
                                        "rttMs",
                                        "jitterMs",
                                        "slackTicks",
                                        "downLossPercent",
                                        "upLossPercent",
                                        "downBytesPerSecond",
                                        "upBytesPerSecond",
                                        "downPacketsPerSecond",
                                        "upPacketsPerSecond",
                                        "correctionsPer1000Ticks",
                                        "maxCorrectionSubunits",
                                        "mispredictedPer1000Ticks",
                                        "missedInputsPer1000Ticks",
                                        "hashMismatches",
                                        "resyncs",
                                        "confirmedTicks",
                                        "resumes",
                                        "longestDatagramBytes"};

class Bots : public ServerTest {
 protected:
  std::map<std::string, double> play(std::vector<std::string> options) {
    options.insert(options.begin(), address());
    options.push_back("--json");
    Process bots(platonCommand("platon-bot", options));
    EXPECT_EQ(bots.wait(), 0) << bots.errors();
    return numbersOf(bots.output());
  }
};

TEST_F(Bots, StayInLockstepUnderPerfectConditions) {
  startServer();
  const auto numbers = play({"--count", "4", "--seconds", "6", "--seed", "3"});
  ASSERT_EQ(numbers.size(), kKeys.size());
  for (const std::string& key : kKeys) EXPECT_TRUE(numbers.contains(key)) << key;
  EXPECT_EQ(numbers.at("connected"), 4);
  EXPECT_EQ(numbers.at("failed"), 0);
  EXPECT_GT(numbers.at("confirmedTicks"), 200);
  EXPECT_EQ(numbers.at("hashMismatches"), 0);
  EXPECT_EQ(numbers.at("resyncs"), 0);
  stopServer();
}

TEST_F(Bots, HollowBotsPlayTogetherWithOthers) {
  startServer();
  Process hollow(platonCommand("platon-bot",
                               {address(), "--count", "8", "--seconds", "7", "--hollow", "--delay", "30", "--json"}));
  const auto numbers = play({"--count", "2", "--seconds", "6", "--settle", "3"});
  EXPECT_EQ(numbers.at("failed"), 0);
  EXPECT_GT(numbers.at("confirmedTicks"), 0);
  EXPECT_LT(numbers.at("confirmedTicks"), 270);  // three seconds at most, and the ticks that were delayed before
  EXPECT_EQ(numbers.at("hashMismatches"), 0);
  EXPECT_EQ(hollow.wait(), 0) << hollow.errors();
  EXPECT_EQ(hollow.output().rfind("{\"connected\":8,\"failed\":0,", 0), 0u) << hollow.output();
  EXPECT_NE(hollow.output().find("\"resyncs\":null"), std::string::npos) << hollow.output();
  stopServer();
  EXPECT_EQ(server().errors().find("desync"), std::string::npos) << server().errors();
}

TEST_F(Bots, StayInLockstepUnderBadConditions) {
  startServer();
  const auto numbers = play({"--count", "4", "--seconds", "8", "--seed", "3", "--loss", "10", "--delay", "40",
                             "--jitter", "20", "--duplicate", "3", "--reorder", "3"});
  EXPECT_EQ(numbers.at("connected"), 4);
  EXPECT_EQ(numbers.at("failed"), 0);
  EXPECT_GT(numbers.at("confirmedTicks"), 200);
  EXPECT_GE(numbers.at("rttMs"), 80);  // the simulated conditions are in effect
  EXPECT_EQ(numbers.at("hashMismatches"), 0);
  EXPECT_EQ(numbers.at("resyncs"), 0);
  stopServer();
}

}  // namespace
}  // namespace platon::bots_test
