#include "client/scene/solid_mesh.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::solid_mesh_test {
namespace {

constexpr double kSize = 480;

class SolidMeshTest : public testing::TestWithParam<int> {
 protected:
  SolidKind kind() const { return static_cast<SolidKind>(GetParam()); }
  int corners() const { return PlatonicSolid::of(kind()).edgesPerFace(); }
};

TEST_P(SolidMeshTest, FaceTowardsAndOnSurfaceFindTheFaceOfAPoint) {
  const SolidMesh mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    const glm::dvec3 point = mesh.toWorld(face, mesh.polygon()[0] * 0.9);
    EXPECT_EQ(mesh.faceTowards(point * 3.0), face);
    EXPECT_LT(glm::distance(mesh.onSurface(point * 0.5), point), 1e-9);
  }
}

// Crossing an edge along its normal keeps position and up: the turn of the topology is the rotation in space.
TEST_P(SolidMeshTest, PoseIsContinuousOverEveryEdge) {
  const SolidMesh mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    for (int edge = 0; edge < corners(); ++edge) {
      const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(face, edge);
      const glm::dvec2 normal = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
      const glm::dvec2 along(-normal.y, normal.x);
      const double angle = std::atan2(along.y, along.x) - std::acos(0.0);  // up is along the edge
      const Pose here = mesh.pose(face, normal * mesh.apothem(), angle);
      const glm::dvec2 there = mesh.edgeNormals()[next.edge] * mesh.apothem();
      const Pose beyond = mesh.pose(next.face, there, angle + toRadians(next.turn));
      EXPECT_LT(glm::distance(here.position, beyond.position), 1e-9);
      EXPECT_LT(glm::distance(here.up, beyond.up), 1e-9);
      EXPECT_NEAR(glm::dot(here.up, here.normal), 0, 1e-12);
    }
  }
}

TEST_P(SolidMeshTest, IsBetweenTwoPointsWhereverTheWayGoesThroughIt) {
  const SolidMesh mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    const glm::dvec3 middle = mesh.toWorld(face, {0, 0});
    const glm::dvec3 eye = middle + 500.0 * mesh.normal(face) + glm::dvec3(30, -20, 10);
    EXPECT_FALSE(mesh.isBetween(eye, middle)) << "on a face in front";
    EXPECT_FALSE(mesh.isBetween(eye, middle + mesh.normal(face)));
    EXPECT_TRUE(mesh.isBetween(eye, mesh.onSurface(-middle))) << "on a face behind";
    EXPECT_TRUE(mesh.isBetween(mesh.onSurface(-middle) * 1.1, eye));
    const glm::dvec3 beside = 1.01 * mesh.toWorld(face, mesh.polygon()[0]);
    EXPECT_FALSE(mesh.isBetween(eye, beside));
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolids, SolidMeshTest, testing::Range(0, kSolidKinds));

}  // namespace
}  // namespace platon::solid_mesh_test
