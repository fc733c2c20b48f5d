#include "platon/physics/segment.h"

#include <gtest/gtest.h>

namespace platon::segment_test {
namespace {

constexpr Box kBox{{-2, 3}, {10, 7}};

void expectBox(const Box& box, Point low, Point high) {
  EXPECT_EQ(box.low, low);
  EXPECT_EQ(box.high, high);
}

TEST(SegmentTest, BoundsContainBothEndsInAnyOrder) {
  expectBox(boundsOf({{4, -1}, {-3, 8}}), {-3, -1}, {4, 8});
  expectBox(boundsOf({{-3, 8}, {4, -1}}), {-3, -1}, {4, 8});
  expectBox(boundsOf({{5, 5}, {5, 5}}), {5, 5}, {5, 5});
}

TEST(SegmentTest, EqualityDependsOnTheDirection) {
  EXPECT_EQ((Segment{{1, 2}, {3, 4}}), (Segment{{1, 2}, {3, 4}}));
  EXPECT_NE((Segment{{1, 2}, {3, 4}}), (Segment{{3, 4}, {1, 2}}));
}

TEST(BoxTest, JoinedContainsBoth) {
  expectBox(kBox.joined({{-5, 4}, {0, 9}}), {-5, 3}, {10, 9});
  expectBox(kBox.joined({{0, 4}, {1, 5}}), kBox.low, kBox.high);
}

TEST(BoxTest, TouchingBoxesOverlap) {
  EXPECT_TRUE(kBox.overlaps({{10, 7}, {20, 20}})) << "a common corner";
  EXPECT_TRUE(kBox.overlaps({{-9, -9}, {-2, 3}}));
  EXPECT_TRUE(kBox.overlaps({{0, 4}, {1, 5}})) << "inside";
  EXPECT_TRUE(Box({{0, 4}, {1, 5}}).overlaps(kBox));
  EXPECT_FALSE(kBox.overlaps({{11, 3}, {20, 7}}));
  EXPECT_FALSE(kBox.overlaps({{-9, 3}, {-3, 7}}));
  EXPECT_FALSE(kBox.overlaps({{-2, 8}, {10, 9}}));
  EXPECT_FALSE(kBox.overlaps({{-2, -9}, {10, 2}}));
}

TEST(BoxTest, ContainsBoxesThatTouchItsBorderFromInside) {
  EXPECT_TRUE(kBox.contains(kBox));
  EXPECT_TRUE(kBox.contains({{0, 4}, {0, 4}}));
  EXPECT_FALSE(kBox.contains({{-3, 3}, {10, 7}}));
  EXPECT_FALSE(kBox.contains({{-2, 2}, {10, 7}}));
  EXPECT_FALSE(kBox.contains({{-2, 3}, {11, 7}}));
  EXPECT_FALSE(kBox.contains({{-2, 3}, {10, 8}}));
}

TEST(BoxTest, GrowsByTheMarginOnEverySide) {
  expectBox(kBox.grown(4), {-6, -1}, {14, 11});
  expectBox(kBox.grown(0), kBox.low, kBox.high);
}

TEST(BoxTest, SweptContainsStartAndEnd) {
  expectBox(kBox.swept({5, -6}), {-2, -3}, {15, 7});
  expectBox(kBox.swept({-5, 6}), {-7, 3}, {10, 13});
  expectBox(kBox.swept({}), kBox.low, kBox.high);
}

}  // namespace
}  // namespace platon::segment_test
