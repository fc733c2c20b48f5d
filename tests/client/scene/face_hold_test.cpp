#include "client/scene/face_hold.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"
#include "tests/client/scene/surface_walk.h"

namespace platon::face_hold_test {
namespace {

// Distance of a place from the middle of the picture, in half shorter sides.
double outwards(const ViewPoint& view, glm::dvec3 place) {
  const glm::dvec3 seen = glm::conjugate(view.orientation) * (place - view.eye);
  return std::max(std::abs(seen.x), std::abs(seen.y)) / -seen.z / CameraTarget::kTangent;
}

TEST(FaceHold, StandsStillAndShowsTheWholeFace) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    FaceHold hold;
    const ViewPoint first = hold.view(mesh.pose(0, {0, 0}, 1), mesh, 1);
    EXPECT_NEAR(glm::dot(first.back(), mesh.normal(0)), 1, 1e-12);
    for (const glm::dvec2 corner : mesh.polygon()) {
      EXPECT_EQ(hold.view(mesh.pose(0, corner, 1), mesh, 1).eye, first.eye);
      EXPECT_LT(outwards(first, mesh.toWorld(0, corner)), 0.9);
    }
  }
}

TEST(FaceHold, CutsToTheNextFaceWithThePlayerUpright) {
  const SolidMesh mesh(SolidKind::kTetrahedron, 480);
  FaceHold hold;
  hold.view(mesh.pose(0, {0, 0}, 0), mesh, 1);
  const Pose player = mesh.pose(2, {10, 10}, 2.5);
  const ViewPoint view = hold.view(player, mesh, 1);
  EXPECT_NEAR(glm::dot(view.back(), player.normal), 1, 1e-12);
  EXPECT_NEAR(glm::dot(view.up(), player.up), 1, 1e-12);
  const Pose turned = mesh.pose(2, {10, 10}, 1);
  EXPECT_NEAR(glm::dot(hold.view(turned, mesh, 1).up(), turned.up), 1, 1e-12);
}

TEST(FaceHold, OnALargeFaceThePlayerStaysAwayFromTheBorder) {
  const SolidMesh mesh(SolidKind::kHexahedron, 65536);
  FaceHold hold;
  SurfaceWalk walk{&mesh, 0, {0, 0}, 0};
  glm::dvec3 last = hold.view(walk.pose(), mesh, 1).eye;
  int cuts = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    walk.step({3.2, 1});
    const ViewPoint view = hold.view(walk.pose(), mesh, 1);
    EXPECT_LT(outwards(view, walk.pose().position), 0.71);
    cuts += view.eye != last ? 1 : 0;
    last = view.eye;
  }
  EXPECT_GT(cuts, 20);
  EXPECT_LT(cuts, 60);
}

TEST(FaceHold, ZoomMagnifies) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  const Pose player = mesh.pose(0, {30, 0}, 0);
  FaceHold hold;
  const double far = glm::length(hold.view(player, mesh, 1).eye) - mesh.inradius();
  EXPECT_NEAR(glm::length(hold.view(player, mesh, 0.5).eye) - mesh.inradius(), 2 * far, 1e-6);
  EXPECT_LT(glm::length(hold.view(player, mesh, 2).eye), far);
}

}  // namespace
}  // namespace platon::face_hold_test
