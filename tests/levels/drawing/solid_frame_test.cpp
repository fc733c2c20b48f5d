#include "levels/drawing/solid_frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace platon::solid_frame_test {
namespace {

constexpr double kSize = 480;

class SolidFrameTest : public testing::TestWithParam<int> {
 protected:
  SolidKind kind() const { return static_cast<SolidKind>(GetParam()); }
  int corners() const { return PlatonicSolid::of(kind()).edgesPerFace(); }
};

glm::dvec3 cornerOf(const SolidFrame& mesh, int face, int corner) {
  return mesh.toWorld(face, mesh.polygon()[static_cast<std::size_t>(corner)]);
}

TEST_P(SolidFrameTest, SharedVerticesCoincide) {
  for (const double size : {1.0, kSize, 65536.0}) {
    const SolidFrame mesh(kind(), size);
    std::map<int, glm::dvec3> places;
    for (int face = 0; face < mesh.faces(); ++face) {
      for (int corner = 0; corner < corners(); ++corner) {
        const glm::dvec3 place = cornerOf(mesh, face, corner);
        const auto [first, isNew] = places.emplace(mesh.solid().vertex(face, corner), place);
        EXPECT_LT(glm::distance(first->second, place), 1e-9)
            << "size " << size << " face " << face << " corner " << corner;
      }
    }
    for (const auto& [a, placeOfA] : places) {
      for (const auto& [b, placeOfB] : places) EXPECT_TRUE(a == b || glm::distance(placeOfA, placeOfB) > size * 0.999);
    }
  }
}

TEST_P(SolidFrameTest, EveryEdgeCoincidesReversedWithThatOfTheNeighbour) {
  const SolidFrame mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    for (int edge = 0; edge < corners(); ++edge) {
      const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(face, edge);
      const int nextCorner = (next.edge + 1) % corners();
      EXPECT_LT(glm::distance(cornerOf(mesh, face, edge), cornerOf(mesh, next.face, nextCorner)), 1e-9);
      EXPECT_LT(glm::distance(cornerOf(mesh, face, (edge + 1) % corners()), cornerOf(mesh, next.face, next.edge)),
                1e-9);
    }
  }
}

TEST_P(SolidFrameTest, UnfoldingKeepsTheCommonEdge) {
  const SolidFrame mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    for (int edge = 0; edge < corners(); ++edge) {
      const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(face, edge);
      const glm::dvec4 there(mesh.polygon()[(next.edge + 1U) % mesh.polygon().size()], 0, 1);
      const glm::dvec4 here(mesh.polygon()[static_cast<std::size_t>(edge)], 0, 1);
      EXPECT_LT(glm::distance(mesh.unfolded(face, edge) * there, here), 1e-9);
    }
  }
}

TEST_P(SolidFrameTest, NormalsPointOutwardsAndTheSolidIsConvex) {
  const SolidFrame mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    EXPECT_NEAR(glm::length(mesh.normal(face)), 1, 1e-12);
    EXPECT_NEAR(glm::determinant(mesh.faceToWorld(face)), 1, 1e-12);
    EXPECT_NEAR(glm::dot(mesh.normal(face), mesh.toWorld(face, {0, 0})), mesh.inradius(), 1e-9);
    for (int other = 0; other < mesh.faces(); ++other) {
      for (int corner = 0; corner < corners(); ++corner) {
        EXPECT_LT(glm::dot(mesh.normal(face), cornerOf(mesh, other, corner)), mesh.inradius() + 1e-9);
      }
    }
  }
}

TEST_P(SolidFrameTest, CornersLieOnTheCircumsphereOneEdgeLengthApart) {
  const SolidFrame mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    for (int corner = 0; corner < corners(); ++corner) {
      EXPECT_NEAR(glm::length(cornerOf(mesh, face, corner)), mesh.circumradius(), 1e-9);
      EXPECT_NEAR(glm::distance(cornerOf(mesh, face, corner), cornerOf(mesh, face, (corner + 1) % corners())), kSize,
                  1e-9);
    }
  }
}

TEST_P(SolidFrameTest, NeighboursMeetAtTheDihedralAngle) {
  const SolidFrame mesh(kind(), kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    for (int edge = 0; edge < corners(); ++edge) {
      const double cosine = glm::dot(mesh.normal(face), mesh.normal(mesh.solid().neighbour(face, edge).face));
      EXPECT_NEAR(cosine, -std::cos(mesh.dihedral()), 1e-12);
    }
  }
}

TEST_P(SolidFrameTest, PolygonEqualsThatOfThePhysics) {
  const SolidFrame mesh(kind(), kSize);
  const std::vector<Point> exact = facePolygon(kind(), static_cast<std::int32_t>(kSize));
  ASSERT_EQ(exact.size(), mesh.polygon().size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_LT(glm::distance(toUnits(exact[i]), mesh.polygon()[i]), 0.75 / kSubunitsPerUnit);
  }
}

TEST(SolidFrame, CircumradiiEqualTheKnownFormulas) {
  EXPECT_NEAR(SolidFrame(SolidKind::kTetrahedron, 1).circumradius(), std::sqrt(6.0) / 4, 1e-12);
  EXPECT_NEAR(SolidFrame(SolidKind::kHexahedron, 1).circumradius(), std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(SolidFrame(SolidKind::kOctahedron, 1).circumradius(), std::sqrt(2.0) / 2, 1e-12);
  EXPECT_NEAR(SolidFrame(SolidKind::kDodecahedron, 1).circumradius(), std::sqrt(3.0) * (1 + std::sqrt(5.0)) / 4, 1e-12);
  EXPECT_NEAR(SolidFrame(SolidKind::kIcosahedron, 1).circumradius(), std::sqrt(10 + 2 * std::sqrt(5.0)) / 4, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(AllSolids, SolidFrameTest, testing::Range(0, kSolidKinds));

class UnfoldingTest : public testing::TestWithParam<int> {
 protected:
  SolidKind kind() const { return static_cast<SolidKind>(GetParam()); }
};

glm::dvec2 placeIn(const Unfolding& unfolding, int face, glm::dvec2 point) {
  return glm::dvec2(unfolding.faceToPlane(face) * glm::dvec4(point, 0, 1));
}

std::vector<glm::dvec2> polygonIn(const Unfolding& unfolding, const SolidFrame& solid, int face) {
  std::vector<glm::dvec2> polygon;
  for (const glm::dvec2 corner : solid.polygon()) polygon.push_back(placeIn(unfolding, face, corner));
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

TEST_P(UnfoldingTest, EveryFaceIsPlacedOnce) {
  const SolidFrame solid(kind(), kSize);
  const Unfolding unfolding(solid);
  std::set<int> placed = {unfolding.hinges().front().face};
  for (const Unfolding::Hinge& hinge : unfolding.hinges()) {
    EXPECT_TRUE(placed.contains(hinge.face)) << "face " << hinge.face << " was not placed before others hung on it";
    const int next = solid.solid().neighbour(hinge.face, hinge.edge).face;
    EXPECT_TRUE(placed.insert(next).second) << "face " << next << " is placed twice";
  }
  EXPECT_EQ(placed.size(), static_cast<std::size_t>(solid.faces()));
}

TEST_P(UnfoldingTest, FacesKeepTheirShapeAndSide) {
  const SolidFrame solid(kind(), kSize);
  const Unfolding unfolding(solid);
  for (int face = 0; face < solid.faces(); ++face) {
    const glm::dvec2 x(unfolding.faceToPlane(face)[0]);
    const glm::dvec2 y(unfolding.faceToPlane(face)[1]);
    EXPECT_NEAR(glm::length(x), 1, 1e-12);
    EXPECT_LT(glm::distance(y, glm::dvec2(-x.y, x.x)), 1e-12);
  }
}

TEST_P(UnfoldingTest, BothFacesOfAHingeHaveItsEdge) {
  const SolidFrame solid(kind(), kSize);
  const Unfolding unfolding(solid);
  const auto corners = static_cast<int>(solid.polygon().size());
  for (const Unfolding::Hinge& hinge : unfolding.hinges()) {
    const PlatonicSolid::Neighbour& next = solid.solid().neighbour(hinge.face, hinge.edge);
    const auto corner = [&](int face, int index) {
      return placeIn(unfolding, face, solid.polygon()[static_cast<std::size_t>(index % corners)]);
    };
    EXPECT_LT(glm::distance(corner(hinge.face, hinge.edge), corner(next.face, next.edge + 1)), 1e-9);
    EXPECT_LT(glm::distance(corner(hinge.face, hinge.edge + 1), corner(next.face, next.edge)), 1e-9);
  }
}

TEST_P(UnfoldingTest, NoTwoFacesOverlap) {
  const SolidFrame solid(kind(), kSize);
  const Unfolding unfolding(solid);
  for (int a = 0; a < solid.faces(); ++a) {
    for (int b = 0; b < a; ++b) {
      const auto polygonOfA = polygonIn(unfolding, solid, a);
      const auto polygonOfB = polygonIn(unfolding, solid, b);
      const double distance = std::max(separation(polygonOfA, polygonOfB), separation(polygonOfB, polygonOfA));
      EXPECT_GT(distance, -1e-9) << "faces " << a << " and " << b;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolids, UnfoldingTest, testing::Range(0, kSolidKinds));

// The middle of a face, in edges of a face.
glm::dvec2 middleOf(const Unfolding& unfolding, int face) { return placeIn(unfolding, face, {0, 0}) / kSize; }

// The unfolding that docs/level_format.md draws.
TEST(Unfolding, TheHexahedronIsACross) {
  const Unfolding unfolding(SolidFrame(SolidKind::kHexahedron, kSize));
  const glm::dvec2 middles[] = {{0, 0}, {1, 0}, {2, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (int face = 0; face < 6; ++face) {
    EXPECT_LT(glm::distance(middleOf(unfolding, face), middles[static_cast<std::size_t>(face)]), 1e-12) << face;
  }
}

TEST(Unfolding, TheTetrahedronIsATriangleWithTheBaseInTheMiddle) {
  const Unfolding unfolding(SolidFrame(SolidKind::kTetrahedron, kSize));
  EXPECT_LT(glm::length(middleOf(unfolding, 3)), 1e-12);
  EXPECT_GT(middleOf(unfolding, 0).y, 0.5);
  EXPECT_NEAR(middleOf(unfolding, 1).y, middleOf(unfolding, 2).y, 1e-12);
  EXPECT_LT(middleOf(unfolding, 2).x, middleOf(unfolding, 1).x);
  EXPECT_LT(middleOf(unfolding, 1).y, 0);
}

TEST(Unfolding, TheRowsOfTheIcosahedronGoFromLeftToRight) {
  const Unfolding unfolding(SolidFrame(SolidKind::kIcosahedron, kSize));
  for (int row = 0; row < 4; ++row) {
    for (int column = 1; column < 5; ++column) {
      const glm::dvec2 step = middleOf(unfolding, 5 * row + column) - middleOf(unfolding, 5 * row + column - 1);
      EXPECT_LT(glm::distance(step, glm::dvec2(1, 0)), 1e-12) << "face " << 5 * row + column;
    }
    EXPECT_TRUE(row == 0 || middleOf(unfolding, 5 * row).y > middleOf(unfolding, 5 * row - 5).y) << "row " << row;
  }
}

TEST(Unfolding, TheStripOfTheOctahedronHasAFaceAboveAndOneBelow) {
  const Unfolding unfolding(SolidFrame(SolidKind::kOctahedron, kSize));
  const int strip[] = {3, 0, 1, 5, 6, 7};
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_NEAR(middleOf(unfolding, strip[i]).x - middleOf(unfolding, strip[i - 1]).x, 0.5, 1e-12);
  }
  EXPECT_NEAR(middleOf(unfolding, 4).x, middleOf(unfolding, 0).x, 1e-12);
  EXPECT_NEAR(middleOf(unfolding, 2).x, middleOf(unfolding, 1).x, 1e-12);
  EXPECT_GT(middleOf(unfolding, 2).y, middleOf(unfolding, 1).y);
  EXPECT_LT(middleOf(unfolding, 4).y, middleOf(unfolding, 0).y);
}

TEST(Unfolding, TheFlowersOfTheDodecahedronLieSideBySide) {
  const Unfolding unfolding(SolidFrame(SolidKind::kDodecahedron, kSize));
  for (int face = 1; face <= 5; ++face) {
    EXPECT_NEAR(glm::distance(middleOf(unfolding, face), middleOf(unfolding, 0)), 1.3763819204711736, 1e-9) << face;
    EXPECT_NEAR(glm::distance(middleOf(unfolding, face + 5), middleOf(unfolding, 11)), 1.3763819204711736, 1e-9)
        << face + 5;
  }
  const glm::dvec2 between = middleOf(unfolding, 11) - middleOf(unfolding, 0);
  EXPECT_LT(std::abs(between.y), 0.2 * between.x);
}

}  // namespace

}  // namespace platon::solid_frame_test
