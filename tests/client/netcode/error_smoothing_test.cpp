#include "client/netcode/error_smoothing.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace platon::error_smoothing_test {
namespace {

using std::chrono::milliseconds;

constexpr Moment kStart = std::chrono::hours(2);

struct Correction {
  Point offset;
  Moment at;
};

// Sum of all fading corrections: each fades linearly within 100 ms and is rounded towards zero.
Point expected(const std::vector<Correction>& corrections, Moment now) {
  Point sum;
  for (const Correction& correction : corrections) {
    const std::int64_t left = 100'000 - (now - correction.at).count();
    if (left <= 0 || now < correction.at) continue;
    sum += Point(static_cast<std::int32_t>(correction.offset.x * left / 100'000),
                 static_cast<std::int32_t>(correction.offset.y * left / 100'000));
  }
  return sum;
}

// `count` corrections in various directions, evenly spread over 100 ms.
std::vector<Correction> series(int count) {
  std::vector<Correction> corrections;
  for (int i = 0; i < count; ++i) {
    corrections.push_back(
        {Point((i * 7 % 5 - 2) * 9000, (i * 3 % 4 - 1) * 7000), kStart + milliseconds(100) * i / count});
  }
  return corrections;
}

TEST(ErrorSmoothing, IsZeroAtFirst) { EXPECT_EQ(ErrorSmoothing().at(kStart), Point()); }

TEST(ErrorSmoothing, FadesMonotonicallyToZero) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000, -500), kStart);
  EXPECT_EQ(smoothing.at(kStart), Point(1000, -500));
  Point last(1000, -500);
  for (int ms = 1; ms <= 150; ++ms) {
    const Point now = smoothing.at(kStart + milliseconds(ms));
    EXPECT_LE(now.x, last.x);
    EXPECT_GE(now.y, last.y);
    last = now;
  }
  EXPECT_EQ(smoothing.at(kStart + milliseconds(50)), Point(500, -250));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(100)), Point());
}

TEST(ErrorSmoothing, ACorrectionLastsAHundredMilliseconds) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000, 0), kStart);
  smoothing.add(Point(0, 300), kStart + milliseconds(50));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(50)), Point(500, 300));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(75)), Point(250, 225));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(100)), Point(0, 150));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(150)), Point());
}

TEST(ErrorSmoothing, CorrectionsFadeIndependently) {
  for (const int count : {2, 10, static_cast<int>(ErrorSmoothing::kMaxCorrections)}) {
    ErrorSmoothing smoothing;
    const std::vector<Correction> corrections = series(count);
    auto next = corrections.begin();
    for (Moment now = kStart; now <= kStart + milliseconds(210); now += std::chrono::microseconds(250)) {
      for (; next != corrections.end() && next->at <= now; ++next) smoothing.add(next->offset, next->at);
      ASSERT_EQ(smoothing.at(now), expected(corrections, now)) << count << " corrections, " << (now - kStart).count();
    }
    EXPECT_EQ(smoothing.at(kStart + milliseconds(200)), Point());
  }
}

// The prediction jumps by -offset at the same moment, so the drawn position, which is their sum, does not jump.
TEST(ErrorSmoothing, TheDrawnPositionDoesNotJump) {
  for (const int count : {1, 10, 32}) {
    ErrorSmoothing smoothing;
    const std::vector<Correction> corrections = series(count);
    Point prediction;
    Point last;
    auto next = corrections.begin();
    for (int ms = 0; ms <= 210; ++ms) {
      const Moment now = kStart + milliseconds(ms);
      std::int64_t fading = 0;
      for (const Correction& one : corrections) {
        const bool fades = one.at <= now && now - one.at <= milliseconds(101);
        fading += fades ? std::abs(one.offset.x) + std::abs(one.offset.y) : 0;
      }
      for (; next != corrections.end() && next->at <= now; ++next) {
        const Point before = smoothing.at(next->at);
        smoothing.add(next->offset, next->at);
        prediction -= next->offset;
        const Point jump = smoothing.at(next->at) - next->offset - before;
        EXPECT_LE(std::abs(jump.x) + std::abs(jump.y), 2) << count << " corrections, " << ms << " ms";
      }
      const Point drawn = prediction + smoothing.at(now);
      const std::int64_t moved = std::abs(drawn.x - last.x) + std::abs(drawn.y - last.y);
      EXPECT_LE(moved, fading / 100 + 2 * count) << count << " corrections, " << ms << " ms";
      last = drawn;
    }
  }
}

TEST(ErrorSmoothing, DropsTheOldestCorrectionWhenFull) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000000, 0), kStart);
  for (std::size_t i = 1; i < ErrorSmoothing::kMaxCorrections; ++i) smoothing.add(Point(0, 1), kStart);
  EXPECT_EQ(smoothing.at(kStart), Point(1000000, 31));
  smoothing.add(Point(0, 1), kStart);
  EXPECT_EQ(smoothing.at(kStart), Point(0, 32));
}

TEST(ErrorSmoothing, ClearRemovesAllCorrections) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000, 0), kStart);
  smoothing.clear();
  EXPECT_EQ(smoothing.at(kStart), Point());
}

}  // namespace
}  // namespace platon::error_smoothing_test
