#include <gtest/gtest.h>

#include "tests/exactness/oracle/trace/sample_trace.h"

namespace platon::oracle::trace_format_test {
namespace {

using RuleNames = std::set<std::string>;

const RuleNames kFormat{"format"};

/// The sample's lines with the first occurrence of `old` in line `line` replaced.
std::vector<std::string> linesWith(std::size_t line, const std::string& old, const std::string& replacement) {
  const SampleTrace trace = sampleTrace();
  std::vector<std::string> lines{toJson(trace.header)};
  for (const TraceTick& tick : trace.ticks) lines.push_back(toJson(tick));
  const std::size_t at = lines[line].find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return lines[line].replace(at, old.size(), replacement), lines;
}

RuleNames rulesViolatedWith(std::size_t line, const std::string& old, const std::string& replacement) {
  return violatedRules(linesWith(line, old, replacement));
}

TEST(TraceFormat, AcceptsSpacesAroundAColon) {
  EXPECT_EQ(rulesViolatedWith(1, "\"tick\":1", "\"tick\" : 1"), RuleNames{});
}

TEST(TraceFormat, AnEmptyTraceIsRefused) {
  EXPECT_EQ(violatedRules(std::vector<std::string>{}), kFormat);
  EXPECT_EQ(violatedRules(std::vector<std::string>{""}), kFormat);
}

TEST(TraceFormat, EveryKeyIsRequired) {
  EXPECT_EQ(rulesViolatedWith(0, "\"subunits\":1024,", ""), kFormat);
  EXPECT_EQ(rulesViolatedWith(0, "\"face\":3,", ""), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"hash\":\"0123456789abcdef\",", ""), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, ",\"angle\":0", ""), kFormat);
  EXPECT_EQ(rulesViolatedWith(0, ",\"elements\":[]", ""), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"open\":[],", ""), kFormat);
}

TEST(TraceFormat, ElementsHaveAFaceALineAndAWord) {
  const auto violatedBy = [](const std::string& element) {
    return rulesViolatedWith(0, "\"elements\":[]", "\"elements\":[{" + element + "}]").contains("format");
  };
  EXPECT_FALSE(violatedBy("\"face\":0,\"line\":0,\"word\":\"key\",\"k\":3"));
  EXPECT_FALSE(violatedBy("\"face\":0,\"line\":0,\"word\":\"hazard\""));
  EXPECT_TRUE(violatedBy("\"face\":0,\"line\":0,\"k\":3"));
  EXPECT_TRUE(violatedBy("\"face\":0,\"word\":\"hazard\""));
  EXPECT_TRUE(violatedBy("\"face\":0,\"line\":0,\"word\":3"));
  EXPECT_TRUE(violatedBy("\"face\":0,\"line\":0,\"word\":\"key\",\"k\":-1"));
  EXPECT_TRUE(rulesViolatedWith(1, "\"open\":[]", "\"open\":[true]").contains("format"));
}

TEST(TraceFormat, UnknownAndRepeatedKeysAreRefused) {
  EXPECT_EQ(rulesViolatedWith(0, "\"subunits\"", "\"size\":400,\"subunits\""), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"angle\":0", "\"angle\":0,\"speed\":3"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"angle\":0", "\"angle\":0,\"angle\":0"), kFormat);
}

TEST(TraceFormat, ValuesOfOtherTypesAreRefused) {
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":1000.0"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":1e3"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":01000"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":\"1000\""), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":null"), kFormat);
  EXPECT_EQ(rulesViolatedWith(2, "\"via\":[7,1]", "\"via\":[7]"), kFormat);
  EXPECT_EQ(rulesViolatedWith(2, "\"via\":[7,1]", "\"via\":[7,1,2]"), kFormat);
  EXPECT_EQ(rulesViolatedWith(2, "\"via\":[7,1]", "\"via\":7"), kFormat);
}

TEST(TraceFormat, NumbersOutOfRangeAreRefused) {
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":536870912"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "\"x\":1000", "\"x\":99999999999999999999"), kFormat);
  EXPECT_EQ(rulesViolatedWith(0, "\"subunits\":1024", "\"subunits\":1000"), kFormat);
}

TEST(TraceFormat, HashesHaveSixteenDigits) {
  EXPECT_EQ(rulesViolatedWith(1, "0123456789abcdef", "0123456789abcde"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "0123456789abcdef", "0123456789ABCDEF"), kFormat);
}

TEST(TraceFormat, EveryLineIsOneJsonValue) {
  EXPECT_EQ(rulesViolatedWith(1, "}]]}]}", "}]]}]} x"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "}]]}]}", "}]]}],}"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "}]]}]}", "}]]}]"), kFormat);
  EXPECT_EQ(rulesViolatedWith(1, "}]]}]}", "},]]}]}"), kFormat);
}

TEST(TraceFormat, TicksAreConsecutive) { EXPECT_EQ(rulesViolatedWith(2, "\"tick\":2", "\"tick\":3"), kFormat); }

TEST(TraceFormat, EveryPlayerOccursOnceAndHasLegs) {
  SampleTrace trace = sampleTrace();
  trace.ticks[0].players.push_back(trace.ticks[0].players[0]);
  EXPECT_EQ(violatedRules(trace), kFormat);
  trace = sampleTrace();
  trace.ticks[0].players[0].legs.clear();
  EXPECT_EQ(violatedRules(trace), kFormat);
}

TEST(TraceFormat, AShapeEqualToThatOfTheHeaderIsRefused) {
  SampleTrace trace = sampleTrace();
  trace.leg(0, 0)[0].shape = trace.header.shape;
  EXPECT_TRUE(violatedRules(trace).contains("format"));
}

}  // namespace
}  // namespace platon::oracle::trace_format_test
