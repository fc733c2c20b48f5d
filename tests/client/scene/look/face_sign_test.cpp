#include "client/scene/look/face_sign.h"

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::face_sign_test {
namespace {

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
}  // namespace platon::face_sign_test
