#include "client/scene/camera_ease.h"

#include <gtest/gtest.h>

namespace platon::camera_ease_test {
namespace {

TEST(CameraEase, IsAnExponentialBelowTheLargestSpeed) {
  EXPECT_NEAR(leftAfter(0.5, 4, 2, 0.25), 0.5 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(leftAfter(0.5, 4, 2, 0), 0.5);
  EXPECT_EQ(leftAfter(0, 4, 2, 1), 0);
}

TEST(CameraEase, IsEvenAtTheLargestSpeed) {
  EXPECT_NEAR(leftAfter(3, 4, 2, 0.5), 2, 1e-15);
  EXPECT_NEAR(leftAfter(3, 4, 2, 1.25), 0.5, 1e-15) << "from here on exponential";
  EXPECT_NEAR(leftAfter(3, 4, 2, 1.5), 0.5 * std::exp(-1.0), 1e-15);
}

TEST(CameraEase, TwoStepsEqualOneStepOfTheSum) {
  for (const double distance : {0.1, 1.0, 3.0}) {
    for (const double a : {0.0, 0.3, 1.0, 2.0}) {
      for (const double b : {0.01, 0.5, 2.0})
        EXPECT_NEAR(leftAfter(leftAfter(distance, 7, 1.5, a), 7, 1.5, b), leftAfter(distance, 7, 1.5, a + b), 1e-12);
    }
  }
}

TEST(CameraEase, AWayBeginsAndEndsSlowly) {
  EXPECT_EQ(smootherstep(0), 0);
  EXPECT_EQ(smootherstep(0.25), 0.103515625);
  EXPECT_EQ(smootherstep(0.5), 0.5);
  EXPECT_EQ(smootherstep(1), 1);
}

}  // namespace
}  // namespace platon::camera_ease_test
