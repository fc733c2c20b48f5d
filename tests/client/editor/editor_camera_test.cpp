#include "client/editor/editor_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace platon::editor_camera_test {
namespace {

TEST(EditorCameraTest, TheWholeSolidIsSeen) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    EditorCamera view;
    view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
    const glm::dmat4 toClip = view.camera(mesh, 1280, 720).viewProjection();
    for (int face = 0; face < mesh.faces(); ++face) {
      for (const glm::dvec2 corner : mesh.polygon()) {
        const glm::dvec4 clip = toClip * glm::dvec4(mesh.toWorld(face, corner), 1);
        EXPECT_LT(std::abs(clip.x / clip.w), 1);
        EXPECT_LT(std::abs(clip.y / clip.w), 1);
      }
    }
  }
}

TEST(EditorCameraTest, CentringPutsTheFaceUpright) {
  const SolidMesh mesh(SolidKind::kDodecahedron, 300);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  view.centre(mesh.pose(7, {0, 0}, 0));
  const Camera camera = view.camera(mesh, 1280, 720);
  EXPECT_LT(glm::distance(camera.back(), mesh.normal(7)), 1e-9);
  EXPECT_LT(glm::distance(camera.up(), mesh.pose(7, {0, 0}, 0).up), 1e-9);
}

TEST(EditorCameraTest, TheSolidFollowsThePointer) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  view.centre(mesh.pose(0, {0, 0}, 0));
  const auto drawn = [&] {
    const glm::dvec4 clip = view.camera(mesh, 1280, 720).viewProjection() * glm::dvec4(mesh.toWorld(0, {0, 0}), 1);
    return glm::dvec2(clip.x / clip.w * 640, -clip.y / clip.w * 360);
  };
  view.drag(mesh, {10, 0});
  EXPECT_NEAR(drawn().x, 10, 0.5);
  view.drag(mesh, {-10, 12});
  EXPECT_NEAR(drawn().x, 0, 0.5);
  EXPECT_NEAR(drawn().y, 12, 0.5);
}

TEST(EditorCameraTest, TheDistanceIsBounded) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  view.zoom(mesh, 1000);
  EXPECT_GT(glm::length(view.camera(mesh, 10, 10).eye()), mesh.inradius() + 50);
  view.zoom(mesh, -1000);
  EXPECT_LT(glm::length(view.camera(mesh, 10, 10).eye()), 12 * mesh.circumradius());
}

TEST(EditorCameraTest, AWayAsideTurnsTheSolidWithoutTiltingIt) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.centre(mesh.pose(0, {0, 0}, 0));
  const Camera before = view.camera(mesh, 1280, 720);
  view.turn(0.4, 0);
  const Camera after = view.camera(mesh, 1280, 720);
  EXPECT_LT(glm::distance(after.up(), before.up()), 1e-9);
  EXPECT_NEAR(glm::dot(after.back(), before.back()), std::cos(0.4), 1e-9);
}

}  // namespace
}  // namespace platon::editor_camera_test
