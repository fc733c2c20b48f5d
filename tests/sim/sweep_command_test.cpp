#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

#include "tests/sim/commands.h"
#include "tests/sim/sim_options.h"

namespace platon::sim::sweep_command_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Returns what the command prints to stdout and stderr for these queries.
std::string sweepAnswers(const std::string& queries, int expectedStatus = 0) {
  std::ios::sync_with_stdio(false);  // before the redirection, because the same call in the command resets the buffer
  std::istringstream in(queries);
  std::streambuf* const before = std::cin.rdbuf(in.rdbuf());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(sweepCommand({}), expectedStatus);
  std::fflush(stdout);
  std::cin.rdbuf(before);
  std::cin.clear();
  return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
}

TEST(SweepCommandTest, AnswersEveryQueryWithOneLine) {
  const std::string square = "4 -10 -10 10 -10 10 10 -10 10  ";
  EXPECT_EQ(sweepAnswers(square + "0 0  0 -40  -50 -30 50 -30\n"), "hit 2000 4000 0 100\n");
  EXPECT_EQ(sweepAnswers(square + "0 0  0 -20  -50 -30 50 -30\n"), "miss\n") << "touching is not a hit";
  EXPECT_EQ(sweepAnswers(square + "0 0  0 0  -50 -5 50 -5\n"), "hit 0 1 0 0\n");
  EXPECT_EQ(sweepAnswers(square + "0 0  0 0  -50 -50 50 -50\r\n" + square + "0 0 0 0 0 0 0 0"), "miss\nhit 0 1 0 0\n");
  EXPECT_EQ(sweepAnswers(""), "");
}

TEST(SweepCommandTest, NamesAnInvalidLineAndAnswersTheOthers) {
  const std::string good = "3 0 0 9 0 0 9  0 0  0 0  50 50 50 50\n";
  EXPECT_EQ(sweepAnswers(good + "3 0 0 9 0\n" + good, 3),
            "miss\nmiss\nline 2: the line ends before a vertex coordinate\n");
  EXPECT_THAT(sweepAnswers("2 0 0 9 0 0 0 0 0 0 0 0 0\n", 3),
              HasSubstr("line 1: '2' is not valid as the number of vertices: expected an integer from 3 to 1048576"));
  EXPECT_THAT(sweepAnswers("3 0 0 9 0 0 9  0 0  0 0  50 50 50 536870912\n", 3),
              StartsWith("line 1: '536870912' is not valid as a coordinate of the segment"));
  EXPECT_THAT(sweepAnswers("3 0 0 9 0 0 9  0 0  0 0  50 50 50 50 1\n", 3),
              HasSubstr("unexpected text after the query"));
  EXPECT_THAT(sweepAnswers("3 0 0 0 9 9 0  0 0  0 0  50 50 50 50\n", 3), HasSubstr("turns clockwise"));
  EXPECT_THAT(sweepAnswers("\n", 3), StartsWith("line 1: "));
}

TEST(SweepCommandTest, TakesNoArguments) { EXPECT_THROW(sweepCommand({"file"}), UsageError); }

}  // namespace
}  // namespace platon::sim::sweep_command_test
