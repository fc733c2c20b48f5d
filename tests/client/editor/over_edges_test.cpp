#include "client/editor/over_edges.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "client/editor/level_document.h"
#include "levels/drawing/solid_frame.h"

namespace platon::over_edges_test {
namespace {

constexpr std::uint64_t kSeed = 17;

const SolidMesh& cube() {
  static const SolidMesh mesh(SolidKind::kHexahedron, 480);
  return mesh;
}

TEST(OverEdgesTest, ASegmentWithinItsFaceIsOnePiece) {
  const EditedSegment segment{0, {-240, 10}, {240, 20}, {}};
  EXPECT_EQ(splitOverEdges(cube(), segment), std::vector{segment});
}

// Face 1 lies behind edge 1 of face 0, and an edge of a square is reached exactly.
TEST(OverEdgesTest, ASegmentOverAnEdgeIsWrittenOnBothFaces) {
  const std::vector<EditedSegment> pieces =
      splitOverEdges(cube(), {0, {100, 30}, {300, 30}, {ElementKind::kDoor, {4}}});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0], (EditedSegment{0, {100, 30}, {240, 30}, {ElementKind::kDoor, {4}}}));
  EXPECT_EQ(pieces[1].face, 1);
  EXPECT_LT(glm::distance(pieces[1].a, {-240, 30}), 1e-9);
  EXPECT_LT(glm::distance(pieces[1].b, {-180, 30}), 1e-9);
}

TEST(OverEdgesTest, ASegmentMayRunRoundTheSolid) {
  const std::vector<EditedSegment> pieces = splitOverEdges(cube(), {0, {0, 30}, {480 * 4, 30}, {}});
  ASSERT_EQ(pieces.size(), 5U);
  EXPECT_EQ(pieces.back().face, 0);
}

// The ends on the two sides of an edge meet within 3 subunits, as docs/level_format.md says.
TEST(OverEdgesTest, ThePiecesMeetAtTheEdge) {
  std::mt19937_64 random(kSeed);
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const auto solid = static_cast<SolidKind>(kind);
    LevelDocument empty(newLevelText(solid, "x"));
    while (!empty.segments().empty()) empty.erase(0);
    empty.check();
    ASSERT_TRUE(empty.valid());
    const SolidMesh mesh(solid, empty.level()->faceSize);
    const auto face = static_cast<int>(random() % static_cast<unsigned>(mesh.faces()));
    for (std::size_t edge = 0; edge < mesh.edgeNormals().size(); ++edge) {
      const glm::dvec2 normal = mesh.edgeNormals()[edge];
      const glm::dvec2 side(-normal.y, normal.x);
      const auto share = [&random] { return static_cast<double>(random() % 1000) / 1000 - 0.5; };
      const glm::dvec2 from = normal * mesh.apothem() * 0.8 + side * mesh.apothem() * 0.3 * share();
      const glm::dvec2 to = normal * mesh.apothem() * 1.2 + side * mesh.apothem() * 0.3 * share();
      LevelDocument document = empty;
      for (const EditedSegment& piece : splitOverEdges(mesh, {face, from, to, {}})) document.add(piece);
      document.check();
      ASSERT_EQ(document.segments().size(), 2U) << "seed " << kSeed;
      EXPECT_TRUE(document.diagnostics().empty());
      const auto& segments = document.level()->segments;
      const auto next = static_cast<std::size_t>(mesh.solid().neighbour(face, static_cast<int>(edge)).face);
      const Segment first = segments[static_cast<std::size_t>(face)].front();
      const Segment second = segments[next].front();
      const glm::dvec3 here = mesh.toWorld(face, toUnits(first.b));
      const glm::dvec3 there = mesh.toWorld(static_cast<int>(next), toUnits(second.a));
      EXPECT_LT(glm::distance(here, there) * kSubunitsPerUnit, 3) << "seed " << kSeed;
    }
  }
}

// On a square, the direction of each edge is that of an edge of the next face.
TEST(OverEdgesTest, AnUpKeepsPointingTheSameWay) {
  const glm::dvec2 normal = cube().edgeNormals()[1];
  const int behind = cube().solid().neighbour(0, 1).edge;
  for (int up = 0; up < 4; ++up) {
    const std::vector<EditedSegment> pieces =
        splitOverEdges(cube(), {0, normal * 200.0, normal * 280.0, {ElementKind::kUp, {up}}});
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[1].word.numbers[0], (behind + 1 + up) % 4);
  }
}

TEST(OverEdgesTest, TheFaceOfTheFirstEndIsFound) {
  const EditedSegment moved = onFaceOfFirstEnd(cube(), {0, {300, 30}, {310, 50}, {}});
  EXPECT_EQ(moved.face, 1);
  EXPECT_LT(glm::distance(moved.a, {-180, 30}), 1e-9);
  EXPECT_LT(glm::distance(moved.b, {-170, 50}), 1e-9);
}

TEST(UnfoldedPlaneTest, APointerIsFollowedOverEdges) {
  UnfoldedPlane plane(cube(), 0);
  EXPECT_LT(glm::distance(plane.follow({0, {10, 20}}), {10, 20}), 1e-9);
  EXPECT_LT(glm::distance(plane.follow({1, {-200, 20}}), {280, 20}), 1e-9);
  EXPECT_LT(glm::distance(plane.follow({2, {-200, 20}}), {760, 20}), 1e-9);
  EXPECT_LT(glm::distance(plane.follow({3, {-200, 20}}), {1240, 20}), 1e-9);
  EXPECT_LT(glm::distance(plane.follow({0, {10, 20}}), {1930, 20}), 1e-9) << "on, and round the solid";
}

}  // namespace
}  // namespace platon::over_edges_test
