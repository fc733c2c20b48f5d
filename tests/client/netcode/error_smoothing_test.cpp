#include "client/netcode/error_smoothing.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace platon {
namespace {

using std::chrono::milliseconds;

constexpr Moment kStart = std::chrono::hours(2);

struct Correction {
  Point back;
  Moment at;
};

// What is left of all together: each on its own fades evenly within 100 ms, each rounded towards nothing.
Point expected(const std::vector<Correction>& corrections, Moment now) {
  Point sum;
  for (const Correction& correction : corrections) {
    const std::int64_t left = 100'000 - (now - correction.at).count();
    if (left <= 0 || now < correction.at) continue;
    sum += Point(static_cast<std::int32_t>(correction.back.x * left / 100'000),
                 static_cast<std::int32_t>(correction.back.y * left / 100'000));
  }
  return sum;
}

// `count` corrections, evenly over 100 ms, of all directions.
std::vector<Correction> series(int count) {
  std::vector<Correction> corrections;
  for (int i = 0; i < count; ++i) {
    corrections.push_back(
        {Point((i * 7 % 5 - 2) * 9000, (i * 3 % 4 - 1) * 7000), kStart + milliseconds(100) * i / count});
  }
  return corrections;
}

TEST(ErrorSmoothing, IsNothingAtFirst) { EXPECT_EQ(ErrorSmoothing().at(kStart), Point()); }

TEST(ErrorSmoothing, GoesFromAllToNothingAndNeverBack) {
  ErrorSmoothing fade;
  fade.add(Point(1000, -500), kStart);
  EXPECT_EQ(fade.at(kStart), Point(1000, -500));
  Point last(1000, -500);
  for (int ms = 1; ms <= 150; ++ms) {
    const Point now = fade.at(kStart + milliseconds(ms));
    EXPECT_LE(now.x, last.x);
    EXPECT_GE(now.y, last.y);
    last = now;
  }
  EXPECT_EQ(fade.at(kStart + milliseconds(50)), Point(500, -250));
  EXPECT_EQ(fade.at(kStart + milliseconds(100)), Point());
}

TEST(ErrorSmoothing, EachIsGoneAHundredMillisecondsAfterItCame) {
  ErrorSmoothing fade;
  fade.add(Point(1000, 0), kStart);
  fade.add(Point(0, 300), kStart + milliseconds(50));
  EXPECT_EQ(fade.at(kStart + milliseconds(50)), Point(500, 300));
  EXPECT_EQ(fade.at(kStart + milliseconds(75)), Point(250, 225));
  EXPECT_EQ(fade.at(kStart + milliseconds(100)), Point(0, 150));
  EXPECT_EQ(fade.at(kStart + milliseconds(150)), Point());
}

TEST(ErrorSmoothing, ManyFadeEachOnItsOwn) {
  for (const int count : {2, 10, static_cast<int>(ErrorSmoothing::kMax)}) {
    ErrorSmoothing fade;
    const std::vector<Correction> corrections = series(count);
    auto next = corrections.begin();
    for (Moment now = kStart; now <= kStart + milliseconds(210); now += std::chrono::microseconds(250)) {
      for (; next != corrections.end() && next->at <= now; ++next) fade.add(next->back, next->at);
      ASSERT_EQ(fade.at(now), expected(corrections, now)) << count << " corrections, " << (now - kStart).count();
    }
    EXPECT_EQ(fade.at(kStart + milliseconds(200)), Point());
  }
}

// The prediction jumps by -back at the same moment: the picture, which is both together, stays where it is.
TEST(ErrorSmoothing, ThePictureMovesNoFasterThanCorrectionsFade) {
  for (const int count : {1, 10, 100}) {
    ErrorSmoothing fade;
    const std::vector<Correction> corrections = series(count);
    Point prediction;
    Point last;
    auto next = corrections.begin();
    for (int ms = 0; ms <= 210; ++ms) {
      const Moment now = kStart + milliseconds(ms);
      std::int64_t fading = 0;
      for (const Correction& one : corrections) {
        const bool fades = one.at <= now && now - one.at <= milliseconds(101);
        fading += fades ? std::abs(one.back.x) + std::abs(one.back.y) : 0;
      }
      for (; next != corrections.end() && next->at <= now; ++next) {
        const Point before = fade.at(next->at);
        fade.add(next->back, next->at);
        prediction -= next->back;
        const Point jump = fade.at(next->at) - next->back - before;
        EXPECT_LE(std::abs(jump.x) + std::abs(jump.y), 2) << count << " corrections, " << ms << " ms";
      }
      const Point picture = prediction + fade.at(now);
      const std::int64_t moved = std::abs(picture.x - last.x) + std::abs(picture.y - last.y);
      EXPECT_LE(moved, fading / 100 + 2 * count) << count << " corrections, " << ms << " ms";
      last = picture;
    }
  }
}

// More than can be kept: none stays longer than those that came just after it.
TEST(ErrorSmoothing, TooManyAreGoneAHundredMillisecondsAfterTheLast) {
  ErrorSmoothing fade;
  for (int i = 0; i < 1000; ++i) fade.add(Point(1000, 1000), kStart + std::chrono::microseconds(100) * i);
  EXPECT_NE(fade.at(kStart + milliseconds(199)), Point());
  EXPECT_EQ(fade.at(kStart + milliseconds(200)), Point());
}

TEST(ErrorSmoothing, CanBeCut) {
  ErrorSmoothing fade;
  fade.add(Point(1000, 0), kStart);
  fade.clear();
  EXPECT_EQ(fade.at(kStart), Point());
}

}  // namespace
}  // namespace platon
