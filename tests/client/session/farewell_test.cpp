#include "client/session/farewell.h"

#include <gtest/gtest.h>

namespace platon::farewell_test {
namespace {

using std::chrono::milliseconds;

class Farewell : public testing::Test {
 protected:
  // Updates until `closeAfter` updates have been made; returns how long it took.
  Moment run(int closeAfter) {
    const Moment start = now_;
    const auto update = [this](Moment now) {
      EXPECT_EQ(now, now_);
      ++updates_;
    };
    updateUntilClosed(clock_, update, [&] { return updates_ >= closeAfter; });
    return now_ - start;
  }

  Moment now_ = std::chrono::seconds(7);
  Clock clock_{[this] { return now_; }, [this](Moment until) { now_ = until; }};
  int updates_ = 0;
};

TEST_F(Farewell, DoesNotUpdateAClosedConnection) {
  EXPECT_EQ(run(0), Moment{});
  EXPECT_EQ(updates_, 0);
}

TEST_F(Farewell, UpdatesEveryTwoMillisecondsUntilClosed) {
  EXPECT_EQ(run(5), milliseconds(10));
  EXPECT_EQ(updates_, 5);
}

TEST_F(Farewell, EndsAfterHalfASecond) {
  EXPECT_EQ(run(100000), milliseconds(500));
  EXPECT_EQ(updates_, 250);
}

}  // namespace
}  // namespace platon::farewell_test
