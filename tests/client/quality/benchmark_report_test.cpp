#include "client/quality/benchmark_report.h"

#include <gtest/gtest.h>

namespace platon::benchmark_report_test {
namespace {

BenchmarkReport report() {
  return {"a driver",
          300,
          {{{QualityLevel::kLow, 6.25, 9, 11, 0.5, 80},
            {QualityLevel::kMedium, 8, 10, 12, 0.5, 81},
            {QualityLevel::kHigh, 12, 20, 21, 0.5, 81},
            {QualityLevel::kAll, 30.1254, 40, 55, 0.5, 81}}}};
}

TEST(BenchmarkReport, TheDefaultIsTheQualityThatTheTimesChoose) {
  EXPECT_EQ(report().chosen(), QualityLevel::kHigh);
  BenchmarkReport fast = report();
  for (FrameCost& cost : fast.costs) cost.p50Ms = 1;
  EXPECT_EQ(fast.chosen(), QualityLevel::kAll);
}

TEST(BenchmarkReport, TheJsonHasARowForEachQuality) {
  EXPECT_EQ(toJson(report()),
            R"({"driver":"a driver","default":"high","frames":[)"
            R"({"quality":"low","p50Ms":6.250,"p99Ms":9.000,"allCpuMs":11.000,"ownCpuMs":0.500,"drawCalls":80},)"
            R"({"quality":"medium","p50Ms":8.000,"p99Ms":10.000,"allCpuMs":12.000,"ownCpuMs":0.500,"drawCalls":81},)"
            R"({"quality":"high","p50Ms":12.000,"p99Ms":20.000,"allCpuMs":21.000,"ownCpuMs":0.500,"drawCalls":81},)"
            R"({"quality":"all","p50Ms":30.125,"p99Ms":40.000,"allCpuMs":55.000,"ownCpuMs":0.500,"drawCalls":81}]})"
            "\n");
}

TEST(BenchmarkReport, TheJsonEscapesTheDriver) {
  BenchmarkReport named = report();
  named.driver = "a \"driver\" \\\n2";
  const std::string start = R"({"driver":"a \"driver\" \\\u000a2","default":)";
  EXPECT_EQ(toJson(named).substr(0, start.size()), start);
}

TEST(BenchmarkReport, TheTextIsATable) {
  EXPECT_EQ(toText(report()),
            "a driver, 300 frames of each quality\n"
            "quality   p50 ms   p99 ms   all CPU ms   own CPU ms   draw calls\n"
            "low         6.25     9.00        11.00        0.500           80\n"
            "medium      8.00    10.00        12.00        0.500           81\n"
            "high       12.00    20.00        21.00        0.500           81\n"
            "all        30.13    40.00        55.00        0.500           81\n"
            "default: high\n");
}

}  // namespace
}  // namespace platon::benchmark_report_test
