#include "client/netcode/send_schedule.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::send_schedule_test {
namespace {

using std::chrono::milliseconds;

constexpr Input kLeft{Input::kPresent | Input::kLeft};
constexpr Input kRight{Input::kPresent | Input::kRight};

class SendScheduleTest : public testing::Test {
 protected:
  // Adds one input per tick. Returns the ticks at which a message was sent.
  std::vector<std::uint32_t> play(const std::vector<Input>& inputs) {
    std::vector<std::uint32_t> sent;
    for (const Input input : inputs) {
      schedule_.addInput(input);
      ++ticks_;
      if (!due()) continue;
      sent.push_back(ticks_);
      schedule_.sent(now(), ticks_);
    }
    return sent;
  }

  Moment now() const { return milliseconds(ticks_ * 16); }
  bool due() const { return schedule_.due(now(), ticks_); }

  SendSchedule schedule_;
  std::uint32_t ticks_ = 0;
};

TEST_F(SendScheduleTest, SendsAChangeAtOnceAndTwiceMoreElseEveryFourthTick) {
  const std::vector<Input> inputs(20, kLeft);
  EXPECT_EQ(play(inputs), (std::vector<std::uint32_t>{1, 2, 3, 7, 11, 15, 19}));
  EXPECT_EQ(play({kRight, kRight, kRight, kRight, kRight, kRight, kRight}),
            (std::vector<std::uint32_t>{21, 22, 23, 27}));
}

TEST_F(SendScheduleTest, SendsEvery80MillisecondsWithoutInputs) {
  EXPECT_TRUE(schedule_.due(milliseconds(5), 0));
  schedule_.sent(milliseconds(5), 0);
  EXPECT_FALSE(schedule_.due(milliseconds(84), 0));
  EXPECT_TRUE(schedule_.due(milliseconds(85), 0));
}

TEST_F(SendScheduleTest, RepeatsOnlyWithANewInput) {
  play({kLeft});
  EXPECT_FALSE(due());  // although two repetitions remain
  schedule_.addInput(kLeft);
  EXPECT_FALSE(due());  // for a tick that has been sent
  ++ticks_;
  EXPECT_TRUE(due());
}

TEST_F(SendScheduleTest, SendSoonMakesOneMessageDue) {
  play({kLeft});
  schedule_.sendSoon();
  EXPECT_TRUE(due());
  schedule_.sent(now(), ticks_);
  EXPECT_FALSE(due());
}

}  // namespace
}  // namespace platon::send_schedule_test
