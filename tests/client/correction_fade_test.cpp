#include "client/correction_fade.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace platon {
namespace {

using std::chrono::milliseconds;

constexpr Moment kStart = std::chrono::hours(2);

TEST(CorrectionFade, IsNothingAtFirst) { EXPECT_EQ(CorrectionFade().at(kStart), Point()); }

TEST(CorrectionFade, GoesFromAllToNothingAndNeverBack) {
  CorrectionFade fade;
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

TEST(CorrectionFade, AddsToWhatIsLeft) {
  CorrectionFade fade;
  fade.add(Point(1000, 0), kStart);
  fade.add(Point(0, 300), kStart + milliseconds(50));
  EXPECT_EQ(fade.at(kStart + milliseconds(50)), Point(500, 300));
  EXPECT_EQ(fade.at(kStart + milliseconds(150)), Point());
}

TEST(CorrectionFade, CanBeCut) {
  CorrectionFade fade;
  fade.add(Point(1000, 0), kStart);
  fade.clear();
  EXPECT_EQ(fade.at(kStart), Point());
}

}  // namespace
}  // namespace platon
