#include "client/ui/controls/pad_repeat.h"

#include <cstddef>
#include <optional>

#include <gtest/gtest.h>

namespace platon::pad_repeat_test {
namespace {

using Kind = KeyEvent::Kind;
using std::chrono::milliseconds;

constexpr std::size_t kNone = 0;

class PadRepeatTest : public testing::Test {
 protected:
  // Repetitions of `key` in so many milliseconds, with a picture in each of them.
  std::size_t repeatsOf(Key key, int duration) {
    std::size_t count = 0;
    for (int i = 0; i < duration; ++i) {
      now_ += milliseconds(1);
      const std::optional<KeyEvent> event = repeat_.repeat(true, now_);
      if (!event) continue;
      EXPECT_EQ(*event, (KeyEvent{key, Kind::kRepeat}));
      ++count;
    }
    return count;
  }
  // Whether a repetition is due at once.
  bool take(const KeyEvent& event, bool repeats = true) {
    repeat_.observe(event, now_);
    return repeat_.repeat(repeats, now_).has_value();
  }

  PadRepeat repeat_;
  PadRepeat::Time now_{};
};

TEST_F(PadRepeatTest, EachDirectionIsRepeatedAfter400MsAndThenEvery80Ms) {
  for (const Key key : {Key::kPadLeft, Key::kPadRight, Key::kPadUp, Key::kPadDown}) {
    EXPECT_FALSE(take({key, Kind::kPress}));
    EXPECT_EQ(repeatsOf(key, 399), kNone);
    EXPECT_EQ(repeatsOf(key, 1), 1U);
    EXPECT_EQ(repeatsOf(key, 79), kNone);
    EXPECT_EQ(repeatsOf(key, 1), 1U);
    EXPECT_EQ(repeatsOf(key, 800), 10U);
    take({key, Kind::kRelease});
    EXPECT_EQ(repeatsOf(key, 1000), kNone);
  }
}

TEST_F(PadRepeatTest, OtherButtonsAndKeysAreNotRepeated) {
  for (const Key key : {Key::kPadA, Key::kPadWalk, Key::kPadLookLeft, Key::kArrowDown}) {
    take({key, Kind::kPress});
    EXPECT_EQ(repeatsOf(key, 1000), kNone);
  }
}

TEST_F(PadRepeatTest, TheDirectionThatWasPressedLastIsRepeated) {
  take({Key::kPadDown, Kind::kPress});
  take({Key::kPadRight, Kind::kPress});
  EXPECT_EQ(repeatsOf(Key::kPadRight, 480), 2U);
  take({Key::kPadDown, Kind::kRelease});
  EXPECT_EQ(repeatsOf(Key::kPadRight, 80), 1U);
}

TEST_F(PadRepeatTest, ADirectionThatMovedTheBallIsNotRepeatedInTheMenu) {
  take({Key::kPadDown, Kind::kPress}, false);
  EXPECT_EQ(repeatsOf(Key::kPadDown, 1000), kNone);
}

TEST_F(PadRepeatTest, ALatePictureGetsOneRepetition) {
  take({Key::kPadDown, Kind::kPress});
  now_ += milliseconds(1000);
  EXPECT_TRUE(repeat_.repeat(true, now_));
  EXPECT_FALSE(repeat_.repeat(true, now_));
  EXPECT_EQ(repeatsOf(Key::kPadDown, 80), 1U);
}

}  // namespace
}  // namespace platon::pad_repeat_test
