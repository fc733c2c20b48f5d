#include "client/editor/editor_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "tests/client/editor/test_editor.h"

namespace platon::editor_camera_test {
namespace {

TEST(EditorCameraTest, TheWholeSolidIsSeen) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    EditorCamera view;
    view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
    const glm::dmat4 toClip = view.camera(mesh).viewProjection();
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
  const Camera camera = view.camera(mesh);
  EXPECT_LT(glm::distance(camera.back(), mesh.normal(7)), 1e-9);
  EXPECT_LT(glm::distance(camera.up(), mesh.pose(7, {0, 0}, 0).up), 1e-9);
}

TEST(EditorCameraTest, TheSolidFollowsThePointer) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.showAll(mesh, mesh.pose(0, {0, 0}, 0));
  view.centre(mesh.pose(0, {0, 0}, 0));
  const auto drawn = [&] {
    const glm::dvec4 clip = view.camera(mesh).viewProjection() * glm::dvec4(mesh.toWorld(0, {0, 0}), 1);
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
  EXPECT_GT(glm::length(view.camera(mesh).eye()), mesh.inradius() + 50);
  view.zoom(mesh, -1000);
  EXPECT_LT(glm::length(view.camera(mesh).eye()), 12 * mesh.circumradius());
}

TEST(EditorCameraTest, AWayAsideTurnsTheSolidWithoutTiltingIt) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EditorCamera view;
  view.centre(mesh.pose(0, {0, 0}, 0));
  const Camera before = view.camera(mesh);
  view.turn(0.4, 0);
  const Camera after = view.camera(mesh);
  EXPECT_LT(glm::distance(after.up(), before.up()), 1e-9);
  EXPECT_NEAR(glm::dot(after.back(), before.back()), std::cos(0.4), 1e-9);
}

TEST(EditorCameraTest, ArrowsTurnTheSolidAndPagesZoom) {
  TestEditor editor;
  const glm::dvec3 before = editor.camera().back();
  editor.key(Key::kArrowLeft);
  EXPECT_GT(glm::distance(editor.camera().back(), before), 0.05);
  editor.key(Key::kArrowRight);
  EXPECT_LT(glm::distance(editor.camera().back(), before), 1e-9);
  const double far = glm::length(editor.camera().eye());
  editor.key(Key::kPageUp);
  EXPECT_LT(glm::length(editor.camera().eye()), far);
}

TEST(EditorCameraTest, TheRightButtonTurnsTheSolid) {
  TestEditor editor;
  const glm::dvec3 before = editor.camera().back();
  PointerEvent event;
  event.kind = PointerEvent::Kind::kPress;
  event.button = PointerEvent::Button::kRight;
  event.place = {400, 300};
  editor.handle(event);
  event.kind = PointerEvent::Kind::kMove;
  event.place = {500, 300};
  editor.handle(event);
  EXPECT_GT(glm::distance(editor.camera().back(), before), 0.1);
  event.kind = PointerEvent::Kind::kScroll;
  event.scroll = 3;
  const double far = glm::length(editor.camera().eye());
  editor.handle(event);
  EXPECT_LT(glm::length(editor.camera().eye()), far);
}

}  // namespace
}  // namespace platon::editor_camera_test
