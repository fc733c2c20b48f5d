#include "tests/sim/verify/verify_report.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace platon::sim::verify_report_test {
namespace {

Verification found(std::uint32_t ticks) {
  Verification verification;
  verification.ticks = ticks;
  return verification;
}

TEST(VerifyReportTest, SaysNothingOfARecordingThatAgrees) {
  const VerifyReport report = reportOf("a", found(300));
  EXPECT_EQ(report.text, "");
  EXPECT_EQ(report.exitCode, 0);
}

TEST(VerifyReportTest, CountsTheTicksBeforeAFault) {
  Verification cut = found(300);
  cut.fault = "byte 9: cut off";
  EXPECT_EQ(reportOf("a", cut).text, "a: byte 9: cut off; the 300 ticks before agree\n");
  EXPECT_EQ(reportOf("a", cut).exitCode, 3);
  cut.ticks = 0;
  EXPECT_EQ(reportOf("a", cut).text, "a: byte 9: cut off\n");
}

TEST(VerifyReportTest, ADivergenceComesBeforeAFault) {
  Verification both = found(20);
  both.divergence = Divergence{20, 0x0123, 0x4567, {}, {}};
  both.fault = "byte 9: cut off";
  const VerifyReport report = reportOf("a", both);
  EXPECT_EQ(
      report.text,
      "a: desync at tick 20: hash 0000000000000123 replayed, 0000000000004567 recorded; the recording ends before "
      "the next checkpoint, so that no field is known\na: byte 9: cut off\n");
  EXPECT_EQ(report.exitCode, 1);
  EXPECT_EQ(jsonOf(*both.divergence), R"({"tick":20,"hash":"0000000000000123","recordedHash":"0000000000004567"})");
}

TEST(VerifyProgressTest, TellsAfterTwoSecondsThenOnceASecondAndTakesItsLineAway) {
  using std::chrono::milliseconds;
  const VerifyProgress::Time begin{};
  std::vector<std::string> shown;
  int asked = 0;
  {
    VerifyProgress progress([&](const std::string& line) { shown.push_back(line); }, begin);
    for (int time = 0; time < 4100; time += 10) {
      progress.tell(begin + milliseconds(time), [&] {
        ++asked;
        return std::to_string(time);
      });
    }
  }
  EXPECT_EQ(shown, (std::vector<std::string>{"2000", "3000", "4000", ""}));
  EXPECT_EQ(asked, 3);
  shown.clear();
  {
    VerifyProgress([&](const std::string& line) { shown.push_back(line); }, begin).tell(begin, [] { return ""; });
  }
  EXPECT_TRUE(shown.empty());
}

}  // namespace
}  // namespace platon::sim::verify_report_test
