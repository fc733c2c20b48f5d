#include "client/scene/stage_model.h"

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::stage_model_test {
namespace {

std::shared_ptr<const StageModel> stageOf(const std::string& segmentsOfFace0) {
  const LevelResult result = loadLevel("# title: A title\nHEXAHEDRON\n0 -100 -150 90\n1 120 80\n480\n%\n" +
                                       segmentsOfFace0 + "%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return makeStageModel(*result.level);
}

std::size_t ribbonsOf(const StageModel& stage) {
  std::size_t count = 0;
  for (const FaceDrawing& face : stage.faces) count += face.ribbons.size();
  return count;
}

TEST(StageModel, HasTheSegmentsMarkersAndTitleOfTheLevel) {
  const auto stage = stageOf("-100 20.5 100 -40\n0 0 50 50\n");
  EXPECT_EQ(stage->title, "A title");
  EXPECT_EQ(stage->faces.size(), 6U);
  ASSERT_EQ(stage->faces[0].ribbons.size(), 2U);
  EXPECT_EQ(stage->faces[0].ribbons[0].a, glm::vec2(-100, 20.5));
  EXPECT_EQ(stage->faces[0].ribbons[0].b, glm::vec2(100, -40));
  EXPECT_EQ(ribbonsOf(*stage), 2U);
  EXPECT_EQ(stage->start.face, 0);
  EXPECT_EQ(stage->start.place, glm::vec2(-100, -150));
  EXPECT_NEAR(stage->start.angle, 1.5707963, 1e-6);
  EXPECT_EQ(stage->goal.face, 1);
  EXPECT_EQ(stage->goal.place, glm::vec2(120, 80));
}

TEST(StageModel, ASegmentAlongAnEdgeIsDrawnOnBothFaces) {
  const auto stage = stageOf("-100 -240 60 -240\n");
  const PlatonicSolid::Neighbour& below = stage->mesh.solid().neighbour(0, 0);
  ASSERT_EQ(ribbonsOf(*stage), 2U);
  ASSERT_EQ(stage->faces[below.face].ribbons.size(), 1U);
  const Ribbon& here = stage->faces[0].ribbons[0];
  const Ribbon& there = stage->faces[below.face].ribbons[0];
  EXPECT_LT(glm::distance(stage->mesh.toWorld(0, here.a), stage->mesh.toWorld(below.face, there.a)), 1e-4);
  EXPECT_LT(glm::distance(stage->mesh.toWorld(0, here.b), stage->mesh.toWorld(below.face, there.b)), 1e-4);
}

TEST(StageModel, ElementsAreNoRibbons) {
  const auto stage = stageOf("-100 0 100 0\n-100 20 100 20 up 1\n0 0 50 50 door 7\n");
  EXPECT_EQ(ribbonsOf(*stage), 1U);
  ASSERT_EQ(stage->faces[0].elements.size(), 2U);
  const ElementDrawing& up = stage->faces[0].elements[0];
  EXPECT_EQ(up.kind, ElementKind::kUp);
  EXPECT_EQ(up.ends.a, glm::vec2(-100, 20));
  EXPECT_EQ(up.ends.b, glm::vec2(100, 20));
  EXPECT_LT(glm::distance(up.towards, glm::vec2(1, 0)), 1e-6F) << "edge 1 is on the right";
  EXPECT_EQ(up.element, 0U);
  const ElementDrawing& door = stage->faces[0].elements[1];
  EXPECT_EQ(door.kind, ElementKind::kDoor);
  EXPECT_EQ(door.number, 7);
  EXPECT_EQ(door.element, 1U);
}

TEST(StageModel, AnElementAlongAnEdgeIsDrawnOnBothFaces) {
  const auto stage = stageOf("-100 -240 60 -240 up 1\n");
  const std::size_t below = stage->mesh.solid().neighbour(0, 0).face;
  ASSERT_EQ(stage->faces[below].elements.size(), 1U);
  const ElementDrawing& here = stage->faces[0].elements[0];
  const ElementDrawing& there = stage->faces[below].elements[0];
  const auto world = [&](std::size_t face, glm::vec2 point) {
    return stage->mesh.toWorld(static_cast<int>(face), glm::dvec2(point));
  };
  EXPECT_LT(glm::distance(world(0, here.ends.a), world(below, there.ends.a)), 1e-4);
  EXPECT_LT(glm::distance(world(0, here.ends.a + here.towards), world(below, there.ends.a + there.towards)), 1e-4);
  EXPECT_EQ(there.element, here.element);
}

TEST(StageModel, AMarkerNearAnEdgeIsAlsoOnTheNeighbour) {
  const auto stage = stageOf("");
  const Marker marker{0, {0, -230}, 0};
  const PlatonicSolid::Neighbour& below = stage->mesh.solid().neighbour(0, 0);
  const auto beyond = markerOn(stage->mesh, below.face, marker, 20);
  ASSERT_TRUE(beyond);
  EXPECT_NEAR(glm::dot(glm::dvec2(beyond->place), stage->mesh.edgeNormals()[below.edge]), 250, 1e-3);
  EXPECT_FALSE(markerOn(stage->mesh, below.face, marker, 5)) << "the marker is farther from the edge";
  EXPECT_FALSE(markerOn(stage->mesh, stage->mesh.solid().neighbour(0, 2).face, marker, 20)) << "the opposite edge";
  EXPECT_TRUE(markerOn(stage->mesh, 0, marker, 0));
}

TEST(StageModel, AMarkerPointsTheSameWayOnTheNeighbour) {
  const auto stage = stageOf("");
  const SolidMesh& mesh = stage->mesh;
  for (int face = 0; face < mesh.faces(); ++face) {
    for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
      const auto i = static_cast<std::size_t>(edge);
      const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(face, edge);
      const Marker marker{face, glm::vec2(230.0 * mesh.edgeNormals()[i]), 0.3};
      const auto beyond = markerOn(mesh, next.face, marker, 20);
      ASSERT_TRUE(beyond);
      // Seen along the edge, which both faces share.
      const glm::dvec3 along = glm::cross(mesh.normal(face), mesh.normal(next.face));
      const glm::dvec3 here = mesh.pose(face, marker.place, marker.angle).up;
      const glm::dvec3 there = mesh.pose(next.face, beyond->place, beyond->angle).up;
      EXPECT_NEAR(glm::dot(here, along), glm::dot(there, along), 1e-6) << "face " << face << " edge " << edge;
    }
  }
}

TEST(StageModel, FaceLabelsDifferAlsoUpsideDown) {
  const LevelResult result = loadLevel([] {
    std::string text = "ICOSAHEDRON\n0 0 0 0\n1 0 0\n480\n";
    for (int face = 0; face < 20; ++face) text += "%\n";
    return text;
  }());
  ASSERT_TRUE(result.level);
  std::set<std::string> labels;
  const auto stage = makeStageModel(*result.level);
  for (const FaceDrawing& face : stage->faces) labels.insert(face.label);
  EXPECT_EQ(labels.size(), 20U);
  EXPECT_TRUE(labels.contains("6.") && labels.contains("9."));
}

std::shared_ptr<const StageModel> stageOf(const std::string& solid, int faces, const std::string& segments) {
  std::string text = solid + "\n0 0 0 0\n1 0 0\n480\n%\n" + segments;
  for (int face = 1; face < faces; ++face) text += "%\n";
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return makeStageModel(*result.level);
}

TEST(FaceSign, EveryFaceHasAnotherSign) {
  const auto stage = stageOf("ICOSAHEDRON", 20, "");
  std::set<std::tuple<int, int>> signs;
  for (const FaceSign& sign : signsOf(*stage)) {
    signs.insert({sign.corners, sign.dots});
    EXPECT_GE(sign.corners, 3);
    EXPECT_LE(sign.corners, 7);
    EXPECT_GE(sign.dots, 1);
    EXPECT_LE(sign.dots, 4);
  }
  EXPECT_EQ(signs.size(), 20U);
}

TEST(FaceSign, AnEmptyFaceHasItInTheMiddle) {
  const auto stage = stageOf("HEXAHEDRON", 6, "");
  EXPECT_EQ(signsOf(*stage)[3].place, glm::vec2(0));
}

TEST(FaceSign, AvoidsSegmentsStartAndGoal) {
  const auto stage = stageOf("HEXAHEDRON", 6, "-200 -20 200 -20\n-200 100 200 100\n");
  const std::vector<FaceSign> signs = signsOf(*stage);
  EXPECT_GT(std::abs(signs[0].place.y + 20), signs[0].radius);
  EXPECT_GT(std::abs(signs[0].place.y - 100), signs[0].radius);
  EXPECT_GT(glm::length(signs[0].place), signs[0].radius) << "the start";
  EXPECT_GT(glm::length(signs[1].place), signs[1].radius) << "the goal";
  for (const FaceSign& sign : signs) {
    for (const glm::dvec2 edge : stage->mesh.edgeNormals())
      EXPECT_LT(glm::dot(edge, glm::dvec2(sign.place)) + sign.radius, stage->mesh.apothem());
  }
}

}  // namespace

}  // namespace platon::stage_model_test
