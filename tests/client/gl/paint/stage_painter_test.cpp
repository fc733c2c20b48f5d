#include "client/gl/paint/stage_painter.h"

#include <algorithm>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/stage_model.h"
#include "tests/client/gl/render_fixture.h"
#include "tests/client/scene/surface_walk.h"

namespace platon::stage_painter_test {
namespace {

// A circle with a dot in its middle looked the same however its face was turned.
TEST_F(RenderTest, ASignWithOneDotShowsHowItsFaceIsTurned) {
  const auto stage = cube();
  constexpr int kCircle = 4;  // the face with this sign
  const FaceSign sign = signsOf(*stage)[kCircle];
  ASSERT_EQ(sign.corners, 7);
  ASSERT_EQ(sign.dots, 1);
  Scene scene = sceneOf(stage);
  scene.focus = stage->mesh.pose(kCircle, glm::dvec2(sign.place), 0);
  const Image image = draw(scene, kStill);
  const auto brightnessAt = [&](glm::dvec2 offset) {
    const glm::dvec2 place = glm::dvec2(sign.place) + double{sign.radius} * offset;
    return brightness(pixel(image, pixelOf(stage->mesh.toWorld(kCircle, place))));
  };
  EXPECT_LT(brightnessAt({0, -0.3}), brightnessAt({0, 0.3}) - 0.05);
  EXPECT_NEAR(brightnessAt({0, 0}), brightnessAt({0, 0.3}), 0.02);
}

// The least brightness of a top along its axis. Each place counts as bright as the brightest pixel round it.
double faintest(const Image& image, const std::vector<glm::ivec2>& axis) {
  double least = 1;
  for (const glm::ivec2 at : axis) {
    double most = 0;
    for (const int x : {-1, 0, 1}) {
      for (const int y : {-1, 0, 1}) most = std::max(most, brightness(pixel(image, at + glm::ivec2(x, y))));
    }
    least = std::min(least, most);
  }
  return least;
}

// Tops that were thinner than a pixel broke into dashes.
TEST_F(RenderTest, ATopThatIsSeenAlmostFromTheSideHasNoGaps) {
  const Scene scene = sceneOf(stageOf("HEXAHEDRON", 6, "150 -200 162 200\n"));
  const SolidMesh& mesh = scene.stage->mesh;
  camera_.resize(kWidth, kHeight);
  for (const double scale : {1.0, 0.75}) {
    renderer_.setQuality({1, scale, false, true});
    for (const double high : {20.0, 40.0, 80.0, 160.0}) {
      camera_.place(mesh.toWorld(0, {2000, 0}) + high * mesh.normal(0), mesh.normal(0), mesh);
      renderer_.draw(scene, camera_, {}, kStill);
      std::vector<glm::ivec2> axis;
      for (double along = -190; along <= 190; along += 5)
        axis.push_back(pixelOfTop(scene, {156 + 0.03 * along, along}));
      EXPECT_GT(faintest(renderer_.read(), axis), 0.5) << "scale " << scale << ", eye " << high << " above the face";
    }
  }
}

// Sides of walls on faces that were turned away looked like grey plates.
TEST_F(RenderTest, ASideOnAFaceThatIsTurnedAwayHasTheColourOfTheFace) {
  const Scene scene = sceneOf(stageOf("HEXAHEDRON", 6, "150 -200 150 200\n"));
  const SolidMesh& mesh = scene.stage->mesh;
  camera_.resize(kWidth, kHeight);
  const auto sideSeenFrom = [&](double high) {
    camera_.place(mesh.toWorld(0, {2000, 0}) + high * mesh.normal(0), mesh.normal(0), mesh);
    renderer_.draw(scene, camera_, {}, kStill);
    return brightness(pixel(renderer_.read(), pixelOf(mesh.toWorld(0, {152, 0}) + 8.0 * mesh.normal(0))));
  };
  const double face = brightness(glm::vec3(scene.stage->faces[0].colour));
  EXPECT_NEAR(sideSeenFrom(20), 0.8 * face, 0.05);
  EXPECT_GT(sideSeenFrom(1600), face) << "the wall from above";
}

TEST_F(RenderTest, FloorsOfTheFaceAreTintedAfterACrossing) {
  Scene scene = sceneOf(stageOf("HEXAHEDRON", 6, "-200 -100 -100 -100\n0 -150 100 -50\n150 -200 150 0\n"));
  const SolidMesh& mesh = scene.stage->mesh;
  scene.players = {playerAt(*scene.stage, 0, 0, {0, 0})};
  scene.players[0].local = true;
  camera_.resize(kWidth, kHeight);
  camera_.place(mesh.toWorld(0, {0, -100}) + 700.0 * mesh.normal(0), mesh.normal(0), mesh);
  SurfaceWalk walk{&mesh, 0, {236, 100}, 0};
  const auto yellowness = [&](glm::dvec2 way, glm::dvec2 place) {
    walk.step(way);
    for (int frame = 0; frame < 12; ++frame) {
      scene.seconds += 1.0 / 60;
      scene.players[0].pose = walk.pose();
      renderer_.draw(scene, camera_, {}, PictureStyle());
    }
    const glm::vec3 seen = pixel(renderer_.read(), pixelOfTop(scene, place));
    return seen.r - seen.b;
  };
  EXPECT_LT(yellowness({0, 0}, {-150, -100}), 0.2) << "no edge has been crossed";
  EXPECT_LT(yellowness({8, 0}, {-150, -100}), 0.2) << "on the next face";
  EXPECT_GT(yellowness({-8, 0}, {-150, -100}), 0.4) << "level";
  EXPECT_GT(yellowness({0, 0}, {50, -100}), 0.4) << "slope";
  EXPECT_LT(yellowness({0, 0}, {150, -100}), 0.2) << "steep";
}

}  // namespace

}  // namespace platon::stage_painter_test
