#include "client/scene/camera_framing.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/client/scene/surface_walk.h"

namespace platon {
namespace {

glm::dvec2 shiftAt(const SolidMesh& mesh, const Pose& player) {
  return framingShift(cameraTarget(player, mesh, 1), player.position, mesh);
}

TEST(CameraFraming, LeadsTowardsTheCentreOfTheSolid) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EXPECT_LT(glm::length(shiftAt(mesh, mesh.pose(0, {0, 0}, 0))), 1e-9);
  const glm::dvec2 shift = shiftAt(mesh, mesh.pose(0, {100, -150}, 0));
  EXPECT_LT(shift.x, -10);
  EXPECT_GT(shift.y, 10);
}

TEST(CameraFraming, IsBoundedAndSmallOnALargeFace) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : {200.0, 480.0, 65536.0}) {
      const SolidMesh mesh(static_cast<SolidKind>(kind), size);
      const Pose player = mesh.pose(0, 0.6 * mesh.polygon()[0], 1);
      const double halfView = cameraTarget(player, mesh, 1).halfView();
      EXPECT_LE(glm::length(shiftAt(mesh, player)), kMaxFramingShift * halfView * (size > 1000 ? 0.03 : 1) + 1e-9);
    }
  }
}

TEST(CameraFraming, HasNoJumpOnAWalkOverEdges) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    SurfaceWalk walk{&mesh, 0, {0, 20}, 0.3};
    glm::dvec2 last = shiftAt(mesh, walk.pose());
    for (int step = 0; step < 3000; ++step) {
      walk.step({0.5, 0});
      const glm::dvec2 next = shiftAt(mesh, walk.pose());
      EXPECT_LT(glm::distance(last, next), 4);
      last = next;
    }
  }
}

}  // namespace
}  // namespace platon
