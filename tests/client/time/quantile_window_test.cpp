#include "client/time/quantile_window.h"

#include <gtest/gtest.h>

namespace platon::quantile_window_test {
namespace {

TEST(QuantileWindow, OneSampleIsEveryQuantile) {
  QuantileWindow<100> window;
  EXPECT_TRUE(window.empty());
  window.add(7);
  EXPECT_FALSE(window.empty());
  for (const double share : {0.0, 0.5, 0.99, 1.0}) EXPECT_EQ(window.quantile(share), 7);
}

TEST(QuantileWindow, ReturnsTheSmallestSampleThatTheGivenShareOfSamplesDoesNotExceed) {
  QuantileWindow<100> window;
  for (int i = 0; i < 100; ++i) window.add((i * 37) % 100);  // each of 0 … 99 once
  EXPECT_EQ(window.quantile(0), 0);
  EXPECT_EQ(window.quantile(0.5), 49);
  EXPECT_EQ(window.quantile(0.99), 98);
  EXPECT_EQ(window.quantile(1), 99);
}

TEST(QuantileWindow, DropsTheOldestSample) {
  QuantileWindow<3> window;
  for (const double sample : {9.0, 1.0, 2.0, 3.0}) window.add(sample);
  EXPECT_EQ(window.quantile(1), 3);
  window.add(0);
  EXPECT_EQ(window.quantile(0), 0);
  EXPECT_EQ(window.quantile(0.5), 2);
}

}  // namespace
}  // namespace platon::quantile_window_test
