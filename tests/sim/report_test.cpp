#include "tests/sim/report.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/sim/sim_options.h"

namespace platon::sim::report_test {
namespace {

struct Reported {
  int exitCode;
  std::string errors;
};

Reported reported(const std::exception& error) {
  testing::internal::CaptureStderr();
  const int exitCode = report(error);
  return {exitCode, testing::internal::GetCapturedStderr()};
}

TEST(ReportTest, UsageErrorsGet2AndTheNameOfTheProgram) {
  const auto [exitCode, errors] = reported(UsageError("no level"));
  EXPECT_EQ(exitCode, 2);
  EXPECT_EQ(errors, "platon-sim: no level\n");
}

TEST(ReportTest, InputErrorsGet3) {
  const auto [exitCode, errors] = reported(InputError("scene:1:1: error: no shape"));
  EXPECT_EQ(exitCode, 3);
  EXPECT_EQ(errors, "scene:1:1: error: no shape\n");
}

TEST(ReportTest, OtherErrorsGet3) {
  const auto [exitCode, errors] = reported(std::invalid_argument("out of range"));
  EXPECT_EQ(exitCode, 3);
  EXPECT_EQ(errors, "out of range\n");
}

TEST(ReportTest, AnEmptyMessageIsNotPrinted) {
  const auto [exitCode, errors] = reported(InputError(""));
  EXPECT_EQ(exitCode, 3);
  EXPECT_EQ(errors, "");
}

}  // namespace
}  // namespace platon::sim::report_test
