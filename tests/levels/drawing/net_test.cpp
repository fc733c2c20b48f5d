#include "levels/drawing/net.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace platon::net_test {
namespace {

constexpr double kSize = 480;

class NetTest : public testing::TestWithParam<int> {
 protected:
  SolidKind kind() const { return static_cast<SolidKind>(GetParam()); }
};

glm::dvec2 placeIn(const Net& net, int face, glm::dvec2 point) {
  return glm::dvec2(net.faceToPlane(face) * glm::dvec4(point, 0, 1));
}

std::vector<glm::dvec2> polygonIn(const Net& net, const SolidFrame& solid, int face) {
  std::vector<glm::dvec2> polygon;
  for (const glm::dvec2 corner : solid.polygon()) polygon.push_back(placeIn(net, face, corner));
  return polygon;
}

// By how much the lines along the edges of `a` separate it from `b`; negative when none does.
double separation(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double most = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec2 along = glm::normalize(a[(i + 1) % a.size()] - a[i]);
    const glm::dvec2 outwards(along.y, -along.x);
    double nearest = std::numeric_limits<double>::max();
    for (const glm::dvec2 corner : b) nearest = std::min(nearest, glm::dot(corner - a[i], outwards));
    most = std::max(most, nearest);
  }
  return most;
}

TEST_P(NetTest, EveryFaceIsPlacedOnce) {
  const SolidFrame solid(kind(), kSize);
  const Net net(solid);
  std::set<int> placed = {net.hinges().front().face};
  for (const Net::Hinge& hinge : net.hinges()) {
    EXPECT_TRUE(placed.contains(hinge.face)) << "face " << hinge.face << " was not placed before others hung on it";
    const int next = solid.solid().neighbour(hinge.face, hinge.edge).face;
    EXPECT_TRUE(placed.insert(next).second) << "face " << next << " is placed twice";
  }
  EXPECT_EQ(placed.size(), static_cast<std::size_t>(solid.faces()));
}

TEST_P(NetTest, FacesKeepTheirShapeAndSide) {
  const SolidFrame solid(kind(), kSize);
  const Net net(solid);
  for (int face = 0; face < solid.faces(); ++face) {
    const glm::dvec2 x(net.faceToPlane(face)[0]);
    const glm::dvec2 y(net.faceToPlane(face)[1]);
    EXPECT_NEAR(glm::length(x), 1, 1e-12);
    EXPECT_LT(glm::distance(y, glm::dvec2(-x.y, x.x)), 1e-12);
  }
}

TEST_P(NetTest, BothFacesOfAHingeHaveItsEdge) {
  const SolidFrame solid(kind(), kSize);
  const Net net(solid);
  const auto corners = static_cast<int>(solid.polygon().size());
  for (const Net::Hinge& hinge : net.hinges()) {
    const PlatonicSolid::Neighbour& next = solid.solid().neighbour(hinge.face, hinge.edge);
    const auto corner = [&](int face, int index) {
      return placeIn(net, face, solid.polygon()[static_cast<std::size_t>(index % corners)]);
    };
    EXPECT_LT(glm::distance(corner(hinge.face, hinge.edge), corner(next.face, next.edge + 1)), 1e-9);
    EXPECT_LT(glm::distance(corner(hinge.face, hinge.edge + 1), corner(next.face, next.edge)), 1e-9);
  }
}

TEST_P(NetTest, NoTwoFacesOverlap) {
  const SolidFrame solid(kind(), kSize);
  const Net net(solid);
  for (int a = 0; a < solid.faces(); ++a) {
    for (int b = 0; b < a; ++b) {
      const auto polygonOfA = polygonIn(net, solid, a);
      const auto polygonOfB = polygonIn(net, solid, b);
      const double distance = std::max(separation(polygonOfA, polygonOfB), separation(polygonOfB, polygonOfA));
      EXPECT_GT(distance, -1e-9) << "faces " << a << " and " << b;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolids, NetTest, testing::Range(0, kSolidKinds));

// The middle of a face, in edges of a face.
glm::dvec2 middleOf(const Net& net, int face) { return placeIn(net, face, {0, 0}) / kSize; }

// The net that docs/level_format.md draws.
TEST(Net, TheHexahedronIsACross) {
  const Net net(SolidFrame(SolidKind::kHexahedron, kSize));
  const glm::dvec2 middles[] = {{0, 0}, {1, 0}, {2, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (int face = 0; face < 6; ++face) {
    EXPECT_LT(glm::distance(middleOf(net, face), middles[static_cast<std::size_t>(face)]), 1e-12) << face;
  }
}

TEST(Net, TheTetrahedronIsATriangleWithTheBaseInTheMiddle) {
  const Net net(SolidFrame(SolidKind::kTetrahedron, kSize));
  EXPECT_LT(glm::length(middleOf(net, 3)), 1e-12);
  EXPECT_GT(middleOf(net, 0).y, 0.5);
  EXPECT_NEAR(middleOf(net, 1).y, middleOf(net, 2).y, 1e-12);
  EXPECT_LT(middleOf(net, 2).x, middleOf(net, 1).x);
  EXPECT_LT(middleOf(net, 1).y, 0);
}

TEST(Net, TheRowsOfTheIcosahedronGoFromLeftToRight) {
  const Net net(SolidFrame(SolidKind::kIcosahedron, kSize));
  for (int row = 0; row < 4; ++row) {
    for (int column = 1; column < 5; ++column) {
      const glm::dvec2 step = middleOf(net, 5 * row + column) - middleOf(net, 5 * row + column - 1);
      EXPECT_LT(glm::distance(step, glm::dvec2(1, 0)), 1e-12) << "face " << 5 * row + column;
    }
    EXPECT_TRUE(row == 0 || middleOf(net, 5 * row).y > middleOf(net, 5 * row - 5).y) << "row " << row;
  }
}

TEST(Net, TheStripOfTheOctahedronHasAFaceAboveAndOneBelow) {
  const Net net(SolidFrame(SolidKind::kOctahedron, kSize));
  const int strip[] = {3, 0, 1, 5, 6, 7};
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_NEAR(middleOf(net, strip[i]).x - middleOf(net, strip[i - 1]).x, 0.5, 1e-12);
  }
  EXPECT_NEAR(middleOf(net, 4).x, middleOf(net, 0).x, 1e-12);
  EXPECT_NEAR(middleOf(net, 2).x, middleOf(net, 1).x, 1e-12);
  EXPECT_GT(middleOf(net, 2).y, middleOf(net, 1).y);
  EXPECT_LT(middleOf(net, 4).y, middleOf(net, 0).y);
}

TEST(Net, TheFlowersOfTheDodecahedronLieSideBySide) {
  const Net net(SolidFrame(SolidKind::kDodecahedron, kSize));
  for (int face = 1; face <= 5; ++face) {
    EXPECT_NEAR(glm::distance(middleOf(net, face), middleOf(net, 0)), 1.3763819204711736, 1e-9) << face;
    EXPECT_NEAR(glm::distance(middleOf(net, face + 5), middleOf(net, 11)), 1.3763819204711736, 1e-9) << face + 5;
  }
  const glm::dvec2 between = middleOf(net, 11) - middleOf(net, 0);
  EXPECT_LT(std::abs(between.y), 0.2 * between.x);
}

}  // namespace
}  // namespace platon::net_test
