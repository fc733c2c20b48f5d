#include "platon/game/solid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"

namespace platon::solid_test {
namespace {

struct Expected {
  SolidKind kind;
  const char* name;
  int faces;
  int edgesPerFace;
  int vertices;
  int facesAtVertex;
  int defect;  // 360 degrees minus the sum of the angles at a vertex
};

constexpr std::array<Expected, kSolidKinds> kExpected = {{
    {SolidKind::kTetrahedron, "TETRAHEDRON", 4, 3, 4, 3, 180},
    {SolidKind::kHexahedron, "HEXAHEDRON", 6, 4, 8, 3, 90},
    {SolidKind::kOctahedron, "OCTAHEDRON", 8, 3, 6, 4, 120},
    {SolidKind::kDodecahedron, "DODECAHEDRON", 12, 5, 20, 3, 36},
    {SolidKind::kIcosahedron, "ICOSAHEDRON", 20, 3, 12, 5, 60},
}};

class SolidTest : public testing::TestWithParam<Expected> {
 protected:
  const PlatonicSolid& solid() const { return PlatonicSolid::of(GetParam().kind); }

  template <class Visit>
  void forEachEdge(Visit&& visit) const {
    for (int face = 0; face < solid().faces(); ++face) {
      for (int edge = 0; edge < solid().edgesPerFace(); ++edge) visit(face, edge);
    }
  }
};

TEST_P(SolidTest, HasTheKnownNumbersOfFacesEdgesAndVertices) {
  EXPECT_EQ(nameOf(GetParam().kind), GetParam().name);
  EXPECT_EQ(solid().kind(), GetParam().kind);
  EXPECT_EQ(solid().faces(), GetParam().faces);
  EXPECT_EQ(solid().edgesPerFace(), GetParam().edgesPerFace);
  std::set<int> vertices;
  forEachEdge([&](int face, int edge) { vertices.insert(solid().vertex(face, edge)); });
  const int count = static_cast<int>(vertices.size());
  EXPECT_EQ(count, GetParam().vertices);
  EXPECT_EQ(*vertices.begin(), 0);
  EXPECT_EQ(*vertices.rbegin(), count - 1);
  const int edges = GetParam().faces * GetParam().edgesPerFace / 2;
  EXPECT_EQ(count - edges + GetParam().faces, 2) << "Euler's formula";
}

TEST_P(SolidTest, EveryVertexHasTheSameNumberOfFaces) {
  std::vector<int> faces(static_cast<std::size_t>(GetParam().vertices));
  forEachEdge([&](int face, int edge) { ++faces[static_cast<std::size_t>(solid().vertex(face, edge))]; });
  for (const int count : faces) EXPECT_EQ(count, GetParam().facesAtVertex);
}

TEST_P(SolidTest, EveryEdgeIsReversedInTheNeighbour) {
  const int corners = solid().edgesPerFace();
  std::set<std::pair<int, int>> mirrors;
  forEachEdge([&](int face, int edge) {
    const auto& there = solid().neighbour(face, edge);
    const auto& back = solid().neighbour(there.face, there.edge);
    EXPECT_NE(there.face, face);
    EXPECT_EQ(back.face, face);
    EXPECT_EQ(back.edge, edge);
    EXPECT_EQ(solid().vertex(face, edge), solid().vertex(there.face, (there.edge + 1) % corners));
    EXPECT_EQ(solid().vertex(face, (edge + 1) % corners), solid().vertex(there.face, there.edge));
    mirrors.insert({there.face, there.edge});
  });
  EXPECT_EQ(static_cast<int>(mirrors.size()), solid().faces() * corners);
}

TEST_P(SolidTest, TwoFacesShareAtMostOneEdge) {
  std::set<std::pair<int, int>> pairs;
  forEachEdge([&](int face, int edge) {
    EXPECT_TRUE(pairs.insert({face, solid().neighbour(face, edge).face}).second) << face << ", edge " << edge;
  });
}

TEST_P(SolidTest, CrossingAnEdgeAndReturningRotatesByZero) {
  forEachEdge([&](int face, int edge) {
    const auto& there = solid().neighbour(face, edge);
    EXPECT_EQ(there.turn + solid().neighbour(there.face, there.edge).turn, Angle());
  });
}

TEST_P(SolidTest, TurnMapsEveryEdgeToTheReversedEdgeOfTheNeighbour) {
  const int step = Angle::kTurn / solid().edgesPerFace();
  forEachEdge([&](int face, int edge) {
    const auto& there = solid().neighbour(face, edge);
    EXPECT_EQ(Angle(edge * step) + there.turn, Angle(there.edge * step) + Angle::degrees(180));
  });
}

TEST_P(SolidTest, APathAroundAVertexRotatesByTheAngularDefect) {
  const int corners = solid().edgesPerFace();
  forEachEdge([&](int first, int firstCorner) {
    Angle turn;
    int face = first;
    int corner = firstCorner;
    for (int step = 0; step < GetParam().facesAtVertex; ++step) {
      // A counter-clockwise path about a corner leaves the face over the edge that ends there.
      const auto& there = solid().neighbour(face, (corner + corners - 1) % corners);
      turn = turn + there.turn;
      face = there.face;
      corner = there.edge;
      EXPECT_EQ(solid().vertex(face, corner), solid().vertex(first, firstCorner));
    }
    EXPECT_EQ(face, first);
    EXPECT_EQ(corner, firstCorner);
    EXPECT_EQ(turn, Angle::degrees(GetParam().defect));
  });
}

// The laws above hold for any numbering of the faces; level files rely on this one.
TEST(HexahedronTest, Faces0To3FormARingBetween4And5) {
  const PlatonicSolid& solid = PlatonicSolid::of(SolidKind::kHexahedron);
  for (int face = 0; face < 4; ++face) {
    EXPECT_EQ(solid.neighbour(face, 1).face, (face + 1) % 4);
    EXPECT_EQ(solid.neighbour(face, 1).turn, Angle());
    EXPECT_EQ(solid.neighbour(face, 2).face, 4);
    EXPECT_EQ(solid.neighbour(face, 0).face, 5);
  }
  EXPECT_EQ(solid.neighbour(0, 2).turn, Angle());
  EXPECT_EQ(solid.neighbour(0, 0).turn, Angle());
}

void expectNearestPolygon(SolidKind kind, std::int32_t faceSize) {
  const auto polygon = facePolygon(kind, faceSize);
  const int count = PlatonicSolid::of(kind).edgesPerFace();
  ASSERT_EQ(static_cast<int>(polygon.size()), count);
  const long double step = 2 * std::numbers::pi_v<long double> / count;
  const long double radius = static_cast<long double>(faceSize) * kSubunitsPerUnit / (2 * std::sin(step / 2));
  for (int i = 0; i < count; ++i) {
    const long double angle = -std::numbers::pi_v<long double> / 2 + (i - 0.5L) * step;
    const Point corner = polygon[static_cast<std::size_t>(i)];
    EXPECT_LE(std::abs(corner.x - radius * std::cos(angle)), 0.5L + 1e-9L) << "size " << faceSize << ", corner " << i;
    EXPECT_LE(std::abs(corner.y - radius * std::sin(angle)), 0.5L + 1e-9L) << "size " << faceSize << ", corner " << i;
  }
}

TEST_P(SolidTest, PolygonCornersAreRoundedToTheNearestSubunit) {
  for (const std::int32_t size : {kMinFaceSize, 201, 480, 1000, 65535, kMaxFaceSize}) {
    expectNearestPolygon(GetParam().kind, size);
  }
  constexpr unsigned seed = 20240611;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 2000; ++i) {
    expectNearestPolygon(GetParam().kind, kMinFaceSize + static_cast<std::int32_t>(random() % 65337));
  }
}

TEST_P(SolidTest, PolygonIsSymmetricWithAHorizontalFirstEdge) {
  const auto polygon = facePolygon(GetParam().kind, 777);
  EXPECT_EQ(polygon[0], Point(-777 * 512, polygon[1].y));
  EXPECT_EQ(polygon[1].x, 777 * 512);
  std::set<std::pair<std::int32_t, std::int32_t>> corners;
  for (const Point corner : polygon) corners.insert({corner.x, corner.y});
  for (const Point corner : polygon) EXPECT_TRUE(corners.contains({-corner.x, corner.y}));
}

TEST(FacePolygonTest, KnownCorners) {
  EXPECT_EQ(facePolygon(SolidKind::kHexahedron, 480),
            (std::vector<Point>{{-245760, -245760}, {245760, -245760}, {245760, 245760}, {-245760, 245760}}));
  EXPECT_EQ(facePolygon(SolidKind::kTetrahedron, 200),
            (std::vector<Point>{{-102400, -59121}, {102400, -59121}, {0, 118241}}));
  EXPECT_EQ(
      facePolygon(SolidKind::kDodecahedron, 200),
      (std::vector<Point>{{-102400, -140942}, {102400, -140942}, {165687, 53835}, {0, 174213}, {-165687, 53835}}));
}

INSTANTIATE_TEST_SUITE_P(All, SolidTest, testing::ValuesIn(kExpected),
                         [](const auto& spec) { return std::string(spec.param.name); });

}  // namespace
}  // namespace platon::solid_test
