#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "client/gl/renderer.h"
#include "client/scene/solid_folding.h"
#include "tests/client/gl/render_fixture.h"
#include "tests/client/gl/test_stage.h"

namespace platon::folding_pictures_test {
namespace {

using FoldingPictures = RenderTest;

TEST_F(FoldingPictures, FacesAndPlayersAreDrawnWhereTheyAreInTheNet) {
  const auto stage = cube();
  const int beside = stage->mesh.solid().neighbour(0, 2).face;
  const Scene scene = sceneOf(stage, {playerAt(*stage, 1, beside, {60, -140})});
  camera_.setZoom(0.5);
  const auto places = foldedPlaces(stage->mesh, 0, 0);
  const glm::dmat4 carried =
      places.at(static_cast<std::size_t>(beside)) * glm::inverse(stage->mesh.faceToWorld(beside));
  const Image folded = draw(scene);
  renderer_.setPlaces(places);
  const Image flat = draw(scene);
  const auto likeness = [&](const Image& image, glm::dvec3 point) {
    return glm::dot(glm::normalize(pixel(image, pixelOf(point))), glm::normalize(scene.players[0].colour));
  };
  const glm::dvec3 ball = glm::dvec3(carried * glm::dvec4(scene.players[0].pose.position, 1)) +
                          StageModel::kPlayerRadius * stage->mesh.normal(0);
  const glm::dvec3 aside = 0.7 * StageModel::kPlayerRadius * camera_.right();
  EXPECT_GT(likeness(flat, ball + aside), 0.97);
  EXPECT_GT(glm::distance(pixel(flat, pixelOf(ball + 60.0 * camera_.up())),
                          pixel(folded, pixelOf(ball + 60.0 * camera_.up()))),
            0.1F)
      << "the face, where the sky was";
  renderer_.setPlaces({});
  EXPECT_EQ(draw(scene), folded);
}

}  // namespace
}  // namespace platon::folding_pictures_test
