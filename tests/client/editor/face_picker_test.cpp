#include "client/editor/face_picker.h"

#include <gtest/gtest.h>

#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "client/editor/editor_camera.h"
#include "client/ui/overlay.h"

namespace platon::face_picker_test {
namespace {

constexpr double kWidth = 1280;

// Where a place is drawn.
glm::dvec2 screenOf(const SolidMesh& mesh, const Camera& camera, const FacePlace& at) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(mesh.toWorld(at.face, at.place), 1);
  return {(clip.x / clip.w + 1) / 2 * kWidth, (1 - clip.y / clip.w) / 2 * Overlay::kHeight};
}

TEST(FacePickerTest, APlaceIsPickedWhereItIsDrawn) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    for (int face = 0; face < mesh.faces(); ++face) {
      EditorCamera view;
      view.showAll(mesh, mesh.pose(face, {0, 0}, 0.4));
      const Camera camera = view.camera(mesh, 1280, 720);
      const FacePlace at{face, {30, -20}};
      const std::optional<FacePlace> picked = pickFace(mesh, camera, screenOf(mesh, camera, at));
      ASSERT_TRUE(picked);
      EXPECT_EQ(picked->face, face);
      EXPECT_LT(glm::distance(picked->place, at.place), 1e-6);
    }
  }
}

TEST(FacePickerTest, NothingIsPickedBesideTheSolid) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  EXPECT_FALSE(pickFace(mesh, view.camera(mesh, 1280, 720), {5, 5}));
}

TEST(FacePickerTest, TheScaleIsTheDistanceOnTheScreen) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  view.centre(mesh.pose(0, {0, 0}, 0));
  const Camera camera = view.camera(mesh, 1280, 720);
  const double drawn = glm::distance(screenOf(mesh, camera, {0, {0, 0}}), screenOf(mesh, camera, {0, {0, 1}}));
  EXPECT_NEAR(screenScale(mesh, camera, {0, {0, 0}}), drawn, 1e-6);
}

}  // namespace
}  // namespace platon::face_picker_test
