#include "client/scene/view_point.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"

namespace platon::view_point_test {
namespace {

ViewPoint onFace(const SolidMesh& mesh, int face, glm::dvec2 place) {
  const Pose player = mesh.pose(face, place, 0.4);
  const CameraTarget target = cameraTarget(player, mesh, 1);
  return {target.orientation, player.position + target.distance * target.back()};
}

TEST(ViewPoint, DrawnBackByNothingIsTheSameView) {
  const SolidMesh mesh(SolidKind::kOctahedron, 480);
  const ViewPoint view = onFace(mesh, 3, {20, 30});
  const ViewPoint same = drawnBack(mesh, view.orientation, view.fromCentre(), 0);
  EXPECT_LT(glm::distance(same.eye, view.eye), 1e-9);
  EXPECT_EQ(same.orientation, view.orientation);
}

TEST(ViewPoint, DrawnBackEntirelyItLooksAtTheCentreFromAfar) {
  for (const double size : {200.0, 65536.0}) {
    const SolidMesh mesh(SolidKind::kTetrahedron, size);
    const ViewPoint view = onFace(mesh, 0, {10, 5});
    const ViewPoint away = drawnBack(mesh, view.orientation, view.fromCentre(), 1);
    EXPECT_NEAR(glm::dot(glm::normalize(away.eye), view.back()), 1, 1e-9);
    EXPECT_GE(glm::length(away.eye), 2.7 * mesh.circumradius());
  }
}

TEST(ViewPoint, TheEyeIsNeverInTheSolid) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 65536);
    const ViewPoint view = onFace(mesh, 0, mesh.polygon()[0] * 0.9);
    for (double angle = 0; angle < 6; angle += 0.1) {
      const glm::dquat turned = view.orientation * glm::angleAxis(angle, glm::normalize(glm::dvec3(1, 2, 0.5)));
      for (const double part : {0.0, 0.05, 0.5}) {
        const glm::dvec3 eye = drawnBack(mesh, turned, view.fromCentre(), part).eye;
        EXPECT_GT(glm::dot(mesh.normal(mesh.faceTowards(eye)), eye), mesh.inradius() + 80);
      }
    }
  }
}

}  // namespace
}  // namespace platon::view_point_test
