#include "client/editor/picking.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "client/editor/editor_camera.h"
#include "client/ui/overlay.h"

namespace platon::picking_test {
namespace {

constexpr double kWidth = 1280;

// Where a place is drawn.
glm::dvec2 screenOf(const SolidMesh& mesh, const Camera& camera, const FacePlace& at) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(mesh.toWorld(at.face, at.place), 1);
  return {(clip.x / clip.w + 1) / 2 * kWidth, (1 - clip.y / clip.w) / 2 * Overlay::kHeight};
}

TEST(PickingTest, APlaceIsPickedWhereItIsDrawn) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    for (int face = 0; face < mesh.faces(); ++face) {
      EditorCamera view;
      view.showAll(mesh, mesh.pose(face, {0, 0}, 0.4));
      const Camera camera = view.camera(mesh);
      const FacePlace at{face, {30, -20}};
      const std::optional<FacePlace> picked = pickFace(mesh, camera, screenOf(mesh, camera, at));
      ASSERT_TRUE(picked);
      EXPECT_EQ(picked->face, face);
      EXPECT_LT(glm::distance(picked->place, at.place), 1e-6);
    }
  }
}

TEST(PickingTest, NothingIsPickedBesideTheSolid) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  EXPECT_FALSE(pickFace(mesh, view.camera(mesh), {5, 5}));
}

TEST(PickingTest, TheScaleIsTheDistanceOnTheScreen) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  view.centre(mesh.pose(0, {0, 0}, 0));
  const Camera camera = view.camera(mesh);
  const double drawn = glm::distance(screenOf(mesh, camera, {0, {0, 0}}), screenOf(mesh, camera, {0, {0, 1}}));
  EXPECT_NEAR(screenScale(mesh, camera, {0, {0, 0}}), drawn, 1e-6);
}

using Part = PickedSegment::Part;

const std::vector<EditedSegment> kSegments{
    {0, {0, 0}, {90, 0}, {}}, {0, {0, 10}, {90, 10}, {}}, {1, {0, 0}, {90, 0}, {}}};

TEST(PickingTest, TheNearestSegmentOfTheFaceIsPicked) {
  EXPECT_EQ(pickSegment(kSegments, {0, {45, 3}}, 8), (PickedSegment{0, Part::kWhole}));
  EXPECT_EQ(pickSegment(kSegments, {0, {45, 7}}, 8), (PickedSegment{1, Part::kWhole}));
  EXPECT_EQ(pickSegment(kSegments, {1, {45, 7}}, 8), (PickedSegment{2, Part::kWhole}));
  EXPECT_EQ(pickSegment(kSegments, {0, {45, 30}}, 8), std::nullopt);
}

TEST(PickingTest, AnOuterThirdIsAnEnd) {
  EXPECT_EQ(pickSegment(kSegments, {0, {20, 0}}, 8), (PickedSegment{0, Part::kFirstEnd}));
  EXPECT_EQ(pickSegment(kSegments, {0, {95, 0}}, 8), (PickedSegment{0, Part::kSecondEnd}));
}

TEST(PickingTest, APointCanBePicked) {
  const std::vector<EditedSegment> point{{0, {5, 5}, {5, 5}, {}}};
  EXPECT_EQ(pickSegment(point, {0, {6, 5}}, 2)->segment, 0U);
}

}  // namespace
}  // namespace platon::picking_test
