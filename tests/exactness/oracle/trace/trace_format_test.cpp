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

TEST(TraceFormat, TicksAreConsecutive) { EXPECT_EQ(rulesViolatedWith(2, "\"tick\":2", "\"tick\":3"), kFormat); }

TEST(TraceFormat, EveryPlayerOccursOnceAndHasLegs) {
  SampleTrace trace = sampleTrace();
  trace.ticks[0].players.push_back(trace.ticks[0].players[0]);
  EXPECT_EQ(violatedRules(trace), kFormat);
  trace = sampleTrace();
  trace.ticks[0].players[0].legs.clear();
  EXPECT_EQ(violatedRules(trace), kFormat);
}

}  // namespace
}  // namespace platon::oracle::trace_format_test
