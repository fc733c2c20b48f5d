#include "client/netcode/report_schedule.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon {
namespace {

using std::chrono::milliseconds;

constexpr Input kLeft{Input::kPresent | Input::kLeft};
constexpr Input kRight{Input::kPresent | Input::kRight};

class ReportScheduleTest : public testing::Test {
 protected:
  // The ticks after which it was told, of these inputs, a tick after another.
  std::vector<std::uint32_t> play(const std::vector<Input>& inputs) {
    std::vector<std::uint32_t> told;
    for (const Input input : inputs) {
      schedule_.chose(input);
      ++ticks_;
      if (!due()) continue;
      told.push_back(ticks_);
      schedule_.told(now(), ticks_);
    }
    return told;
  }

  Moment now() const { return milliseconds(ticks_ * 16); }
  bool due() const { return schedule_.due(now(), ticks_); }

  ReportSchedule schedule_;
  std::uint32_t ticks_ = 0;
};

TEST_F(ReportScheduleTest, AChangeIsToldAtOnceAndTwiceMoreAndElseEveryFourthTick) {
  const std::vector<Input> inputs(20, kLeft);
  EXPECT_EQ(play(inputs), (std::vector<std::uint32_t>{1, 2, 3, 7, 11, 15, 19}));
  EXPECT_EQ(play({kRight, kRight, kRight, kRight, kRight, kRight, kRight}),
            (std::vector<std::uint32_t>{21, 22, 23, 27}));
}

TEST_F(ReportScheduleTest, WithoutInputsItIsToldEvery80Milliseconds) {
  EXPECT_TRUE(schedule_.due(milliseconds(5), 0));
  schedule_.told(milliseconds(5), 0);
  EXPECT_FALSE(schedule_.due(milliseconds(84), 0));
  EXPECT_TRUE(schedule_.due(milliseconds(85), 0));
}

TEST_F(ReportScheduleTest, NothingIsToldAgainBeforeThereIsAnotherInput) {
  play({kLeft});
  EXPECT_FALSE(due());  // though two repetitions are to come
  schedule_.chose(kLeft);
  EXPECT_FALSE(due());  // for a tick that was told of before
  ++ticks_;
  EXPECT_TRUE(due());
}

TEST_F(ReportScheduleTest, HurryTellsOnceAtOnce) {
  play({kLeft});
  schedule_.hurry();
  EXPECT_TRUE(due());
  schedule_.told(now(), ticks_);
  EXPECT_FALSE(due());
}

}  // namespace
}  // namespace platon
