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

// Corners of the solid were out of the picture.
TEST(ViewPoint, DrawnBackEntirelyItSeesTheWholeSolid) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : {200.0, 480.0, 65536.0}) {
      const SolidMesh mesh(static_cast<SolidKind>(kind), size);
      const ViewPoint view = onFace(mesh, 0, {10, 5});
      const ViewPoint away = drawnBack(mesh, view.orientation, view.fromCentre(), 1);
      EXPECT_NEAR(glm::dot(glm::normalize(away.eye), view.back()), 1, 1e-9);
      for (int face = 0; face < mesh.faces(); ++face) {
        for (const glm::dvec2 corner : mesh.polygon()) {
          const glm::dvec3 seen = glm::conjugate(away.orientation) * (mesh.toWorld(face, corner) - away.eye);
          EXPECT_LT(glm::length(glm::dvec2(seen)) / -seen.z, CameraTarget::kTangent) << kind << " " << size;
        }
      }
    }
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

TEST(CameraEase, IsAnExponentialBelowTheLargestSpeed) {
  EXPECT_NEAR(leftAfter(0.5, 4, 2, 0.25), 0.5 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(leftAfter(0.5, 4, 2, 0), 0.5);
  EXPECT_EQ(leftAfter(0, 4, 2, 1), 0);
}

TEST(CameraEase, IsEvenAtTheLargestSpeed) {
  EXPECT_NEAR(leftAfter(3, 4, 2, 0.5), 2, 1e-15);
  EXPECT_NEAR(leftAfter(3, 4, 2, 1.25), 0.5, 1e-15) << "from here on exponential";
  EXPECT_NEAR(leftAfter(3, 4, 2, 1.5), 0.5 * std::exp(-1.0), 1e-15);
}

TEST(CameraEase, TwoStepsEqualOneStepOfTheSum) {
  for (const double distance : {0.1, 1.0, 3.0}) {
    for (const double a : {0.0, 0.3, 1.0, 2.0}) {
      for (const double b : {0.01, 0.5, 2.0})
        EXPECT_NEAR(leftAfter(leftAfter(distance, 7, 1.5, a), 7, 1.5, b), leftAfter(distance, 7, 1.5, a + b), 1e-12);
    }
  }
}

TEST(CameraEase, AWayBeginsAndEndsSlowly) {
  EXPECT_EQ(smootherstep(0), 0);
  EXPECT_EQ(smootherstep(0.25), 0.103515625);
  EXPECT_EQ(smootherstep(0.5), 0.5);
  EXPECT_EQ(smootherstep(1), 1);
}

}  // namespace

}  // namespace platon::view_point_test
