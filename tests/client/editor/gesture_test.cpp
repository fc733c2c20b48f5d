#include "client/editor/gesture.h"

#include <gtest/gtest.h>

#include <vector>

#include <glm/geometric.hpp>

namespace platon::gesture_test {
namespace {

using Part = PickedSegment::Part;

const SolidMesh& cube() {
  static const SolidMesh mesh(SolidKind::kHexahedron, 480);
  return mesh;
}

std::vector<EditedSegment> moved(const EditedSegment& segment, Part part, glm::dvec2 grabbed, const FacePlace& to) {
  Gesture gesture(cube(), segment, {0, part}, grabbed);
  gesture.follow(to, {}, {}, false);
  return gesture.pieces();
}

TEST(GestureTest, DrawsOverAnEdge) {
  Gesture gesture(cube(), {0, {100, 30}}, {});
  EXPECT_TRUE(gesture.pieces().empty());
  gesture.follow({1, {-101, 32}}, {}, {}, false);
  const std::vector<EditedSegment> pieces = gesture.pieces();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[1].face, 1);
  EXPECT_LT(glm::distance(pieces[1].b, {-100, 30}), 1e-9);
  EXPECT_FALSE(gesture.moved());
}

TEST(GestureTest, AnUnmovedSegmentStaysAsItIs) {
  const EditedSegment segment{0, {-160, -640}, {-160, 190}, {}};
  EXPECT_EQ(Gesture(cube(), segment, {4, Part::kWhole}, {-160, 0}).pieces(), std::vector{segment});
  EXPECT_EQ(Gesture(cube(), segment, {4, Part::kWhole}, {-160, 0}).moved(), 4U);
}

TEST(GestureTest, AClickDoesNotMoveTheEnd) {
  const EditedSegment segment{0, {-200, 30}, {200, 30}, {}};
  Gesture gesture(cube(), segment, {0, Part::kFirstEnd}, {-120, 32});
  gesture.follow({0, {-119, 31}}, {}, {}, false);
  EXPECT_EQ(gesture.pieces(), std::vector{segment});
  gesture.follow({0, {-90, 31}}, {}, {}, false);
  gesture.follow({0, {-120, 32}}, {}, {}, false);
  EXPECT_EQ(gesture.pieces(), (std::vector{EditedSegment{0, {-120, 30}, {200, 30}, {}}})) << "back where it began";
}

TEST(GestureTest, TheFirstEndMovesOverAnEdge) {
  const std::vector<EditedSegment> pieces =
      moved({0, {200, 30}, {100, 30}, {}}, Part::kFirstEnd, {200, 30}, {1, {-200, 30}});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0], (EditedSegment{0, {240, 30}, {100, 30}, {}}));
  EXPECT_LT(glm::distance(pieces[1].a, {-200, 30}), 1e-9) << "the direction stays";
}

TEST(GestureTest, AWholeSegmentMovesToAnotherFace) {
  const std::vector<EditedSegment> pieces =
      moved({0, {150, 30}, {200, 30}, {}}, Part::kWhole, {175, 30}, {1, {-175, 41}});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].face, 1);
  EXPECT_LT(glm::distance(pieces[0].a, {-200, 40}), 1e-9);
}

TEST(GestureTest, ASegmentThatIsCutStaysOnItsFace) {
  const std::vector<EditedSegment> pieces =
      moved({0, {-160, -640}, {-160, 190}, {}}, Part::kSecondEnd, {-160, 190}, {0, {-120, 152}});
  EXPECT_EQ(pieces, (std::vector{EditedSegment{0, {-160, -640}, {-120, 150}, {}}}));
}

}  // namespace
}  // namespace platon::gesture_test
