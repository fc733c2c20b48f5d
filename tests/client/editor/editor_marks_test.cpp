#include "client/editor/editor_marks.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace platon::editor_marks_test {
namespace {

const EditedSegment kSegment{2, {1, 2}, {3, 4}, {}};

TEST(EditorMarksTest, ASelectedSegmentHasEnds) {
  EXPECT_TRUE(marksAbove({}, 1)->empty());
  EditorMarks marks;
  marks.selected = kSegment;
  const FaceMarks all = marksAbove(marks, 1);
  ASSERT_EQ(all->size(), 3U);
  EXPECT_EQ((*all)[0].face, 2);
  EXPECT_EQ((*all)[0].b, glm::vec2(3, 4));
  EXPECT_EQ((*all)[1].a, (*all)[1].b);
}

TEST(EditorMarksTest, FarMarksAreWider) {
  EditorMarks marks;
  marks.drawn = {kSegment};
  EXPECT_GT(marksAbove(marks, 20)->front().width, marksAbove(marks, 1)->front().width);
}

TEST(EditorMarksTest, ReachedPlacesCanBeHidden) {
  LevelReport report;
  report.reached = std::make_shared<const std::vector<FacePlace>>(4);
  report.paths = {{{0, {1, 2}}, {1, {3, 4}}}};
  EXPECT_EQ(marksBelow(report, true)->size(), 6U);
  EXPECT_EQ(marksBelow(report, false)->size(), 2U);
}

}  // namespace
}  // namespace platon::editor_marks_test
