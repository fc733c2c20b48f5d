#include "client/editor/segment_picker.h"

#include <gtest/gtest.h>

#include <optional>

#include <vector>

namespace platon::segment_picker_test {
namespace {

using Part = PickedSegment::Part;

const std::vector<EditedSegment> kSegments{
    {0, {0, 0}, {90, 0}, {}}, {0, {0, 10}, {90, 10}, {}}, {1, {0, 0}, {90, 0}, {}}};

TEST(SegmentPickerTest, TheNearestSegmentOfTheFaceIsPicked) {
  EXPECT_EQ(pickSegment(kSegments, {0, {45, 3}}, 8), (PickedSegment{0, Part::kWhole}));
  EXPECT_EQ(pickSegment(kSegments, {0, {45, 7}}, 8), (PickedSegment{1, Part::kWhole}));
  EXPECT_EQ(pickSegment(kSegments, {1, {45, 7}}, 8), (PickedSegment{2, Part::kWhole}));
  EXPECT_EQ(pickSegment(kSegments, {0, {45, 30}}, 8), std::nullopt);
}

TEST(SegmentPickerTest, AnOuterThirdIsAnEnd) {
  EXPECT_EQ(pickSegment(kSegments, {0, {20, 0}}, 8), (PickedSegment{0, Part::kFirstEnd}));
  EXPECT_EQ(pickSegment(kSegments, {0, {95, 0}}, 8), (PickedSegment{0, Part::kSecondEnd}));
}

TEST(SegmentPickerTest, APointCanBePicked) {
  const std::vector<EditedSegment> point{{0, {5, 5}, {5, 5}, {}}};
  EXPECT_EQ(pickSegment(point, {0, {6, 5}}, 2)->segment, 0U);
}

}  // namespace
}  // namespace platon::segment_picker_test
