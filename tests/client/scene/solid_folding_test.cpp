#include "client/scene/solid_folding.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "client/scene/camera.h"
#include "levels/drawing/solid_frame.h"

namespace platon::solid_folding_test {
namespace {

class SolidFoldingTest : public testing::TestWithParam<int> {
 protected:
  glm::dvec3 corner(const glm::dmat4& place, int index) const {
    const auto& polygon = mesh_.polygon();
    return glm::dvec3(place * glm::dvec4(polygon[static_cast<std::size_t>(index) % polygon.size()], 0, 1));
  }

  SolidMesh mesh_{static_cast<SolidKind>(GetParam()), 480};
};

TEST_P(SolidFoldingTest, TheNetIsFlatInThePlaneOfItsRoot) {
  for (const int root : {0, mesh_.faces() - 1}) {
    for (const glm::dmat4& place : foldedPlaces(mesh_, root, 0)) {
      EXPECT_NEAR(glm::dot(glm::dvec3(place[2]), mesh_.normal(root)), 1, 1e-12);
      EXPECT_NEAR(glm::dot(glm::dvec3(place[3]), mesh_.normal(root)), mesh_.inradius(), 1e-9);
    }
  }
}

TEST_P(SolidFoldingTest, FoldedItIsExactlyTheSolid) {
  const auto places = foldedPlaces(mesh_, 1, 1);
  ASSERT_EQ(places.size(), static_cast<std::size_t>(mesh_.faces()));
  for (int face = 0; face < mesh_.faces(); ++face)
    EXPECT_EQ(places[static_cast<std::size_t>(face)], mesh_.faceToWorld(face));
}

TEST_P(SolidFoldingTest, ItEndsWithoutAJump) {
  const auto places = foldedPlaces(mesh_, 1, 1 - 1e-9);
  for (int face = 0; face < mesh_.faces(); ++face) {
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(glm::distance(corner(places[static_cast<std::size_t>(face)], i), corner(mesh_.faceToWorld(face), i)),
                1e-4);
  }
}

TEST_P(SolidFoldingTest, JoinedFacesShareTheirEdgeAllTheTime) {
  const Unfolding unfolding(mesh_);
  for (const double part : {0.0, 0.3, 0.77, 1.0}) {
    const auto places = foldedPlaces(mesh_, 2, part);
    for (const Unfolding::Hinge& hinge : unfolding.hinges()) {
      const auto& next = mesh_.solid().neighbour(hinge.face, hinge.edge);
      const glm::dmat4& here = places[static_cast<std::size_t>(hinge.face)];
      const glm::dmat4& there = places[next.face];
      EXPECT_LT(glm::distance(corner(here, hinge.edge), corner(there, next.edge + 1)), 1e-9) << part;
      EXPECT_LT(glm::distance(corner(here, hinge.edge + 1), corner(there, next.edge)), 1e-9) << part;
    }
  }
}

TEST_P(SolidFoldingTest, FacesKeepTheirFormAndTheRootItsPlace) {
  for (const double part : {0.0, 0.5}) {
    const auto places = foldedPlaces(mesh_, 2, part);
    for (const glm::dmat4& place : places) EXPECT_NEAR(glm::determinant(place), 1, 1e-9);
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(corner(places[2], i), corner(mesh_.faceToWorld(2), i)), 1e-9);
  }
}

TEST_P(SolidFoldingTest, TheViewShowsTheWholeNetUpright) {
  const Pose root = mesh_.pose(1, {20, -30}, 0.4);
  for (const auto& [width, height] : {std::pair(1280U, 720U), {600U, 900U}}) {
    const UnfoldingView unfolding = viewOfUnfolding(mesh_, root, double{1} * width / height);
    EXPECT_LT(glm::distance(unfolding.view.up(), root.up), 1e-9);
    Camera camera;
    camera.set(root, mesh_, width, height);
    camera.setReach(unfolding.reach);
    camera.show(unfolding.view);
    double widest = 0;
    for (const glm::dmat4& place : foldedPlaces(mesh_, 1, 0)) {
      for (int i = 0; i < mesh_.solid().edgesPerFace(); ++i) {
        const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(corner(place, i), 1);
        widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
        EXPECT_LT(std::abs(clip.z / clip.w), 1);
        EXPECT_LE(glm::length(corner(place, i)), unfolding.reach + 1e-9);
      }
    }
    EXPECT_LT(widest, 1);
    EXPECT_GT(widest, 0.8);
  }
}

INSTANTIATE_TEST_SUITE_P(EverySolid, SolidFoldingTest, testing::Range(0, kSolidKinds));

}  // namespace
}  // namespace platon::solid_folding_test
