#include "levels/drawing/solid_frame.h"

#include <cmath>
#include <cstddef>
#include <map>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "levels/drawing/units.h"

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

}  // namespace
}  // namespace platon::solid_frame_test
