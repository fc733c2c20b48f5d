#include "levels/picture/level_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "tests/support/files.h"
#include "tests/support/test_levels.h"

namespace platon::level_drawing_test {
namespace {

// A hexahedron of edge 480 with these segments on face 0, and the start there.
LevelDrawing drawingOf(const std::string& segments, const std::string& start = "0 0 0 0") {
  const auto level = levelOf("HEXAHEDRON\n" + start + "\n1 30 -40\n480\n%\n" + segments + "%\n%\n%\n%\n%\n");
  return LevelDrawing(*level);
}

TEST(LevelDrawing, HasStartAndGoalInLevelUnits) {
  const LevelDrawing drawing = drawingOf("", "0 -100 50.5 90");
  EXPECT_EQ(drawing.start.face, 0);
  EXPECT_EQ(drawing.start.place, glm::dvec2(-100, 50.5));
  EXPECT_LT(glm::distance(drawing.start.up, glm::dvec2(-1, 0)), 1e-12);
  EXPECT_EQ(drawing.goal.face, 1);
  EXPECT_EQ(drawing.goal.place, glm::dvec2(30, -40));
}

TEST(LevelDrawing, HasEverySegmentOnItsFace) {
  const LevelDrawing drawing = drawingOf("-100 -50 100 -50\n20 100 20 150\n");
  ASSERT_EQ(drawing.faces[0].lines.size(), 2u);
  EXPECT_EQ(drawing.faces[0].lines[0].a, glm::dvec2(-100, -50));
  EXPECT_EQ(drawing.faces[0].lines[1].b, glm::dvec2(20, 150));
  for (std::size_t face = 1; face < 6; ++face) EXPECT_TRUE(drawing.faces[face].lines.empty()) << face;
}

TEST(LevelDrawing, ASegmentAlongAnEdgeIsOnBothFaces) {
  const LevelDrawing drawing = drawingOf("240 -100 240 60\n200 0 240 0\n");
  EXPECT_EQ(drawing.faces[0].lines.size(), 2u);
  ASSERT_EQ(drawing.faces[1].lines.size(), 1u) << "the second segment only ends at the edge";
  EXPECT_LT(glm::distance(drawing.faces[1].lines[0].a, glm::dvec2(-240, -100)), 1e-9);
  EXPECT_LT(glm::distance(drawing.faces[1].lines[0].b, glm::dvec2(-240, 60)), 1e-9);
}

// On the hexahedron, walking right around the ring of faces 0 to 3 keeps down; behind the top edge it is kept, too.
TEST(LevelDrawing, DownIsCarriedOverEachEdgeOfTheStart) {
  const LevelDrawing drawing = drawingOf("");
  for (const std::size_t face : {1U, 3U, 4U, 5U}) {
    ASSERT_TRUE(drawing.faces[face].down) << face;
    const glm::dvec2 down = drawing.faces[face].down->head - drawing.faces[face].down->tail;
    EXPECT_LT(glm::distance(glm::normalize(down), glm::dvec2(0, -1)), 1e-12) << face;
  }
  EXPECT_FALSE(drawing.faces[0].down) << "the start has an arrow of its own";
  EXPECT_FALSE(drawing.faces[2].down) << "the opposite face";
}

TEST(LevelDrawing, OnTheTetrahedronDownDependsOnTheEdge) {
  const LevelDrawing drawing(*levelOf("TETRAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n%\n%\n%\n"));
  for (int edge = 0; edge < 3; ++edge) {
    const PlatonicSolid::Neighbour& next = drawing.solid.solid().neighbour(0, edge);
    const auto& arrow = drawing.faces[next.face].down;
    ASSERT_TRUE(arrow);
    const glm::dmat4 toStart = drawing.solid.unfolded(0, edge);
    const glm::dvec2 down(toStart * glm::dvec4(arrow->head - arrow->tail, 0, 0));
    EXPECT_LT(glm::distance(glm::normalize(down), glm::dvec2(0, -1)), 1e-12) << "unfolded, down stays down";
  }
}

TEST(LevelDrawing, ArrowsLieInsideTheirFaces) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const auto solid = static_cast<SolidKind>(kind);
    std::string text(nameOf(solid));
    text += "\n0 0 0 33\n1 0 0\n480\n";
    for (int face = 0; face < PlatonicSolid::of(solid).faces(); ++face) text += "%\n";
    const LevelDrawing drawing(*levelOf(text));
    for (const LevelDrawing::Face& face : drawing.faces) {
      if (!face.down) continue;
      for (const glm::dvec2 normal : drawing.solid.edgeNormals()) {
        EXPECT_LT(glm::dot(face.down->head, normal), drawing.solid.apothem());
        EXPECT_LT(glm::dot(face.down->tail, normal), drawing.solid.apothem());
      }
    }
  }
}

TEST(LevelDrawing, NumbersStandInTheFirstCornerThatHasRoom) {
  const LevelDrawing free = drawingOf("");
  EXPECT_EQ(free.faces[5].label.text, "5");
  EXPECT_LT(free.faces[0].label.middle.x, -150);
  EXPECT_LT(free.faces[0].label.middle.y, -150);
  const LevelDrawing blocked = drawingOf("-240 -199 -100 -199\n");
  EXPECT_GT(blocked.faces[0].label.middle.x, 150) << "the next corner";
  EXPECT_LT(blocked.faces[0].label.middle.y, -150);
}

TEST(LevelDrawing, ElementsKeepTheirKindAndNumber) {
  const LevelDrawing drawing = drawingOf("-100 -50 100 -50\n20 100 60 100 door 3\n20 150 60 150 plate 3\n");
  const auto& lines = drawing.faces[0].lines;
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(drawing.kinds(), (std::set{ElementKind::kDoor, ElementKind::kPlate}));
  for (const LevelDrawing::Line& line : lines) {
    EXPECT_EQ(line.element.has_value(), line.a.y > 0);
    if (!line.element) continue;
    EXPECT_EQ(line.element->kind, line.a.y == 100 ? ElementKind::kDoor : ElementKind::kPlate);
    EXPECT_EQ(line.element->number, 3);
  }
}

// docs/level_format.md shows its picture, and the golden pictures of the client are of it.
TEST(LevelDrawing, TheLevelWithEveryElementHasEveryKind) {
  const std::string file = "tests/levels/picture/elements.level";
  const std::set<ElementKind> kinds = LevelDrawing(*levelOf(readText(file))).kinds();
  for (const ElementKind kind : kElementKinds)
    EXPECT_TRUE(kinds.contains(kind)) << "add a segment with '" << wordOf(kind) << "' to " << file;
}

TEST(LevelDrawing, TheArrowsOfUpPointToTheirEdgeAlsoOnTheOtherFace) {
  const LevelDrawing drawing = drawingOf("240 -100 240 60 up 2\n");
  ASSERT_TRUE(drawing.faces[0].lines.at(0).element);
  EXPECT_LT(glm::distance(drawing.faces[0].lines[0].element->towards, glm::dvec2(0, 1)), 1e-12);
  ASSERT_TRUE(drawing.faces[1].lines.at(0).element);
  EXPECT_LT(glm::distance(drawing.faces[1].lines[0].element->towards, glm::dvec2(0, 1)), 1e-12);
  const LevelDrawing turned = drawingOf("-100 -240 60 -240 up 1\n", "0 0 0 0");
  ASSERT_TRUE(turned.faces[5].lines.at(0).element) << "face 5 is below, with its edge 2 at the common edge";
  EXPECT_LT(glm::distance(turned.faces[5].lines[0].element->towards, glm::dvec2(1, 0)), 1e-12);
}

}  // namespace
}  // namespace platon::level_drawing_test
