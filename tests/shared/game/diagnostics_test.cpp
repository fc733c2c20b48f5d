#include "platon/game/diagnostics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace platon::diagnostics_test {
namespace {

TEST(DiagnosticsTest, FormatsAsCompilersDo) {
  EXPECT_EQ(format("a.level", {3, 14, true, "too small"}), "a.level:3:14: error: too small");
  EXPECT_EQ(format("a.level", {3, 14, false, "odd"}), "a.level:3:14: warning: odd");
}

TEST(DiagnosticsTest, SortsByPositionAndKeepsTheOrderAtOnePosition) {
  Diagnostics diagnostics;
  diagnostics.error({2, 1}, "fourth");
  diagnostics.warning({1, 9}, "second");
  diagnostics.error({1, 9}, "third");
  diagnostics.warning({1, 2}, "first");
  diagnostics.error({10, 1}, "fifth");
  EXPECT_EQ(diagnostics.take(), (std::vector<Diagnostic>{{1, 2, false, "first"},
                                                         {1, 9, false, "second"},
                                                         {1, 9, true, "third"},
                                                         {2, 1, true, "fourth"},
                                                         {10, 1, true, "fifth"}}));
}

TEST(DiagnosticsTest, OnlyErrorsCountAsErrors) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.hasError());
  diagnostics.warning({}, "warning");
  EXPECT_FALSE(diagnostics.hasError());
  diagnostics.error({}, "error");
  EXPECT_TRUE(diagnostics.hasError());
}

TEST(DiagnosticsTest, KeepsTheLargestNumberOfDiagnostics) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::kMax; ++i) diagnostics.warning({1, 1}, "warning");
  EXPECT_EQ(diagnostics.take(), std::vector<Diagnostic>(Diagnostics::kMax, {1, 1, false, "warning"}));
}

TEST(DiagnosticsTest, ReportsThatSomeWereDropped) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::kMax; ++i) diagnostics.warning({7, 8}, "warning");
  diagnostics.error({1, 1}, "dropped");
  EXPECT_TRUE(diagnostics.hasError()) << "a dropped error is an error";
  const auto all = diagnostics.take();
  ASSERT_EQ(all.size(), Diagnostics::kMax + 1);
  EXPECT_EQ(all.back(), (Diagnostic{7, 8, true, "too many errors and warnings; fix these first"}));
}

TEST(DiagnosticsTest, AnErrorTakesThePlaceOfAWarningWhenThereAreTooMany) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::kMax; ++i) diagnostics.warning({7, 8}, "warning");
  diagnostics.error({9, 1}, "kept");
  diagnostics.warning({9, 2}, "dropped");
  const auto all = diagnostics.take();
  EXPECT_EQ(std::count(all.begin(), all.end(), Diagnostic{9, 1, true, "kept"}), 1);
  EXPECT_EQ(std::count(all.begin(), all.end(), Diagnostic{7, 8, false, "warning"}),
            static_cast<std::ptrdiff_t>(Diagnostics::kMax - 1));
}

TEST(DiagnosticsTest, QuotesPrintableAsciiOnly) {
  EXPECT_EQ(platon::quoted(""), "''");
  EXPECT_EQ(platon::quoted(" a~"), "' a~'");
  EXPECT_EQ(platon::quoted(std::string_view("\0\x1b\x7f\xc3\xa9", 5)), "'" + std::string(5, '?') + "'");
}

TEST(DiagnosticsTest, QuotesAtMost32Bytes) {
  EXPECT_EQ(platon::quoted(std::string(32, 'x')), "'" + std::string(32, 'x') + "'");
  EXPECT_EQ(platon::quoted(std::string(33, 'x')), "'" + std::string(32, 'x') + "...'");
}

}  // namespace
}  // namespace platon::diagnostics_test
