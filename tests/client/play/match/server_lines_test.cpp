#include "client/play/match/live_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace platon::server_lines_test {
namespace {

using std::chrono::seconds;

class ServerLinesTest : public testing::Test {
 protected:
  Time now_ = seconds(1000);
  std::vector<std::string> printed_;
  ServerLines lines_{now_, [this](const std::string& line) { printed_.push_back(line); }};
};

TEST_F(ServerLinesTest, AFewLinesAreAllPrinted) {
  std::vector<std::string> expected;
  for (int i = 0; i < 10; ++i) {
    expected.push_back("line " + std::to_string(i));
    lines_.add(expected.back(), now_);
  }
  now_ += seconds(1);
  lines_.add("later", now_);
  lines_.update(now_ + seconds(100));
  lines_.tell();
  expected.emplace_back("later");
  EXPECT_EQ(printed_, expected);
}

TEST_F(ServerLinesTest, OfAFloodOneLineASecondIsPrintedAndTheNumberOfTheOthersTold) {
  for (int frame = 0; frame < 60 * 60; ++frame) {  // a minute
    lines_.add("again", now_);
    lines_.update(now_);
    now_ += Time(seconds(1)) / 60;
  }
  lines_.tell();
  EXPECT_EQ(std::count(printed_.begin(), printed_.end(), "again"), 10 + 59);
  EXPECT_LE(printed_.size(), 10u + 59 + 6);
  int leftOut = 0;
  for (const std::string& line : printed_) {
    if (line != "again") leftOut += std::stoi(line);
  }
  EXPECT_EQ(leftOut, 3600 - 10 - 59);
}

TEST_F(ServerLinesTest, TheNumberIsToldTenSecondsAfterTheFirst) {
  for (int i = 0; i < 11; ++i) lines_.add("a", now_);
  lines_.update(now_ + seconds(10) - Time(1));
  EXPECT_EQ(printed_.size(), 10u);
  lines_.update(now_ + seconds(10));
  EXPECT_EQ(printed_.back(), "1 line about the server left out: there were too many");
  lines_.update(now_ + seconds(30));
  lines_.tell();
  EXPECT_EQ(printed_.size(), 11u) << "once";
}

}  // namespace
}  // namespace platon::server_lines_test
