#include "levels/picture/solid_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace platon::solid_view_test {
namespace {

class SolidViewTest : public testing::TestWithParam<int> {
 protected:
  SolidFrame solid_{static_cast<SolidKind>(GetParam()), 480};
};

double area(const PlaneMap& map) { return map.x.x * map.y.y - map.x.y * map.y.x; }

void expectFrame(const SolidView& view) {
  EXPECT_NEAR(glm::length(view.right), 1, 1e-12);
  EXPECT_NEAR(glm::length(view.up), 1, 1e-12);
  EXPECT_LT(glm::distance(glm::cross(view.right, view.up), view.towards), 1e-12);
}

TEST_P(SolidViewTest, EveryFaceIsSeenInExactlyOneOfTwoOppositeViewsAndNotFromTheSide) {
  for (int face = 0; face < solid_.faces(); ++face) {
    for (int degrees = -360; degrees <= 360; degrees += 45) {
      const SolidView front = frontView(solid_, face, Angle::degrees(degrees));
      const SolidView back = oppositeOf(front);
      expectFrame(front);
      expectFrame(back);
      EXPECT_TRUE(front.shows(solid_, face));
      for (int other = 0; other < solid_.faces(); ++other) {
        EXPECT_NE(front.shows(solid_, other), back.shows(solid_, other));
        EXPECT_GT(std::abs(glm::dot(front.towards, solid_.normal(other))), 0.2) << other;
      }
    }
  }
}

// Seen from outside, a face keeps its side; the picture's y points down, which turns the sign.
TEST_P(SolidViewTest, FacesAreForeshortenedByTheirSlope) {
  const SolidView view = frontView(solid_, 0, Angle());
  for (int face = 0; face < solid_.faces(); ++face) {
    EXPECT_NEAR(area(view.faceMap(solid_, face)), -glm::dot(view.towards, solid_.normal(face)), 1e-12);
  }
}

TEST_P(SolidViewTest, NeighboursMeetInThePicture) {
  const SolidView view = frontView(solid_, 0, Angle());
  const std::vector<glm::dvec2>& polygon = solid_.polygon();
  for (int face = 0; face < solid_.faces(); ++face) {
    for (std::size_t edge = 0; edge < polygon.size(); ++edge) {
      const PlatonicSolid::Neighbour& next = solid_.solid().neighbour(face, static_cast<int>(edge));
      const glm::dvec2 here = view.faceMap(solid_, face)(polygon[edge]);
      const glm::dvec2 there = view.faceMap(solid_, next.face)(polygon[(next.edge + 1U) % polygon.size()]);
      EXPECT_LT(glm::distance(here, there), 1e-9);
    }
  }
}

TEST_P(SolidViewTest, TheEdgeNearestToDownIsAtTheBottom) {
  const int corners = solid_.solid().edgesPerFace();
  for (int edge = 0; edge < corners; ++edge) {
    for (const int off : {-17, 0, 17}) {
      const SolidView view = frontView(solid_, 0, Angle::degrees(360 / corners * edge + off));
      const PlaneMap map = view.faceMap(solid_, 0);
      const glm::dvec2 down = map(solid_.edgeNormals()[static_cast<std::size_t>(edge)]) - map({0, 0});
      EXPECT_GT(down.y, 0.6 * glm::length(down)) << "edge " << edge << " off by " << off;
    }
  }
}

TEST_P(SolidViewTest, TheOutlineIsTheSameForAllFacesAndAngles) {
  const SolidView reference = frontView(solid_, 0, Angle());
  for (int face = 0; face < solid_.faces(); ++face) {
    const SolidView view = frontView(solid_, face, Angle::degrees(100));
    double lowest = 0;
    double lowestOfReference = 0;
    for (int other = 0; other < solid_.faces(); ++other) {
      for (const glm::dvec2 corner : solid_.polygon()) {
        lowest = std::max(lowest, view.faceMap(solid_, other)(corner).y);
        lowestOfReference = std::max(lowestOfReference, reference.faceMap(solid_, other)(corner).y);
      }
    }
    EXPECT_NEAR(lowest, lowestOfReference, 1e-9);
  }
}

TEST_P(SolidViewTest, LightComesFromAboveOnTheLeft) {
  const SolidView view = frontView(solid_, 0, Angle());
  glm::dvec3 sum(0);
  for (int face = 0; face < solid_.faces(); ++face) {
    const double brightness = view.brightness(solid_, face);
    EXPECT_GE(brightness, 0);
    EXPECT_LE(brightness, 1);
    sum += brightness * solid_.normal(face);
  }
  EXPECT_GT(glm::dot(sum, view.up), glm::dot(sum, view.towards));
  EXPECT_GT(glm::dot(sum, view.towards), 0);
  EXPECT_LT(glm::dot(sum, view.right), 0);
}

INSTANTIATE_TEST_SUITE_P(AllSolids, SolidViewTest, testing::Range(0, kSolidKinds));

}  // namespace
}  // namespace platon::solid_view_test
