#include <gtest/gtest.h>

#include "tests/exactness/oracle/trace/sample_trace.h"

namespace platon::oracle {
namespace {

using Laws = std::set<std::string>;

const Laws kFormat{"format"};

/// The sample's lines with the first occurrence of `old` in line `line` replaced.
std::vector<std::string> linesWith(std::size_t line, const std::string& old, const std::string& replacement) {
  const SampleTrace trace = sampleTrace();
  std::vector<std::string> lines{toJson(trace.header)};
  for (const TraceTick& tick : trace.ticks) lines.push_back(toJson(tick));
  const std::size_t at = lines[line].find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return lines[line].replace(at, old.size(), replacement), lines;
}

Laws lawsWith(std::size_t line, const std::string& old, const std::string& replacement) {
  return brokenLaws(linesWith(line, old, replacement));
}

TEST(TraceFormat, TheSampleIsFine) { EXPECT_EQ(lawsWith(1, "\"tick\":1", "\"tick\" : 1"), Laws{}); }

TEST(TraceFormat, NothingIsNoTrace) {
  EXPECT_EQ(brokenLaws(std::vector<std::string>{}), kFormat);
  EXPECT_EQ(brokenLaws(std::vector<std::string>{""}), kFormat);
}

TEST(TraceFormat, EveryKeyMustBeThere) {
  EXPECT_EQ(lawsWith(0, "\"subunits\":1024,", ""), kFormat);
  EXPECT_EQ(lawsWith(0, "\"face\":3,", ""), kFormat);
  EXPECT_EQ(lawsWith(1, "\"hash\":\"0123456789abcdef\",", ""), kFormat);
  EXPECT_EQ(lawsWith(1, ",\"angle\":0", ""), kFormat);
}

TEST(TraceFormat, NoOtherKeyMayBeThere) {
  EXPECT_EQ(lawsWith(0, "\"subunits\"", "\"size\":400,\"subunits\""), kFormat);
  EXPECT_EQ(lawsWith(1, "\"angle\":0", "\"angle\":0,\"speed\":3"), kFormat);
  EXPECT_EQ(lawsWith(1, "\"angle\":0", "\"angle\":0,\"angle\":0"), kFormat);
}

TEST(TraceFormat, ValuesHaveTheirTypes) {
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":1000.0"), kFormat);
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":1e3"), kFormat);
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":01000"), kFormat);
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":\"1000\""), kFormat);
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":null"), kFormat);
  EXPECT_EQ(lawsWith(2, "\"via\":[7,1]", "\"via\":[7]"), kFormat);
  EXPECT_EQ(lawsWith(2, "\"via\":[7,1]", "\"via\":[7,1,2]"), kFormat);
  EXPECT_EQ(lawsWith(2, "\"via\":[7,1]", "\"via\":7"), kFormat);
}

TEST(TraceFormat, NumbersAreInRange) {
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":536870912"), kFormat);
  EXPECT_EQ(lawsWith(1, "\"x\":1000", "\"x\":99999999999999999999"), kFormat);
  EXPECT_EQ(lawsWith(0, "\"subunits\":1024", "\"subunits\":1000"), kFormat);
}

TEST(TraceFormat, HashesHaveSixteenDigits) {
  EXPECT_EQ(lawsWith(1, "0123456789abcdef", "0123456789abcde"), kFormat);
  EXPECT_EQ(lawsWith(1, "0123456789abcdef", "0123456789ABCDEF"), kFormat);
}

TEST(TraceFormat, ALineIsOneValue) {
  EXPECT_EQ(lawsWith(1, "}]]}]}", "}]]}]} x"), kFormat);
  EXPECT_EQ(lawsWith(1, "}]]}]}", "}]]}],}"), kFormat);
  EXPECT_EQ(lawsWith(1, "}]]}]}", "}]]}]"), kFormat);
  EXPECT_EQ(lawsWith(1, "}]]}]}", "},]]}]}"), kFormat);
}

TEST(TraceFormat, TicksFollowEachOther) { EXPECT_EQ(lawsWith(2, "\"tick\":2", "\"tick\":3"), kFormat); }

TEST(TraceFormat, PlayersAreThereOnceAndHaveLegs) {
  SampleTrace trace = sampleTrace();
  trace.ticks[0].players.push_back(trace.ticks[0].players[0]);
  EXPECT_EQ(brokenLaws(trace), kFormat);
  trace = sampleTrace();
  trace.ticks[0].players[0].legs.clear();
  EXPECT_EQ(brokenLaws(trace), kFormat);
}

TEST(TraceFormat, AShapeIsGivenOnlyWhereItDiffers) {
  SampleTrace trace = sampleTrace();
  trace.leg(0, 0)[0].shape = trace.header.shape;
  EXPECT_TRUE(brokenLaws(trace).contains("format"));
}

}  // namespace
}  // namespace platon::oracle
