#include "client/replay/listed_run.h"

#include <chrono>

#include <gtest/gtest.h>

namespace platon::listed_run_test {
namespace {

TEST(ListedRun, TheDateIsThatOfUtc) {
  const auto day = std::chrono::sys_days(std::chrono::year(2026) / 2 / 28) + std::chrono::seconds(5);
  EXPECT_EQ(dateText(std::chrono::file_clock::from_sys(day)), "2026-02-28");
  EXPECT_EQ(dateText(std::chrono::file_clock::from_sys(day + std::chrono::hours(24))), "2026-03-01");
}

}  // namespace
}  // namespace platon::listed_run_test
