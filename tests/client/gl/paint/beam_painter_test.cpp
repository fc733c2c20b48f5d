#include "client/gl/paint/beam_painter.h"

#include <algorithm>

#include "tests/client/gl/render_fixture.h"

namespace platon::beam_painter_test {
namespace {

// A dash alone at the rim of the solid looked like a mark on the face.
TEST_F(RenderTest, ABeamThatIsHardlyHiddenHasNoDash) {
  const auto stage = cube();
  const Scene scene = sceneOf(stage);
  const SolidMesh& mesh = stage->mesh;
  const glm::dvec3 foot = mesh.toWorld(0, glm::dvec2(stage->goal.place));
  const glm::dvec3 aside = mesh.toWorld(0, {1, 0}) - mesh.toWorld(0, {0, 0});
  camera_.resize(kWidth, kHeight);
  // The most by which the line of the beam is brighter than the face beside it, of `length` from the foot.
  const auto brightest = [&](double below, double length) {
    camera_.place(2000.0 * (mesh.toWorld(0, {0, 1}) - mesh.toWorld(0, {0, 0})) + (240 - below) * mesh.normal(0),
                  mesh.normal(0), mesh);
    EXPECT_TRUE(mesh.isBetween(camera_.eye(), foot));
    renderer_.draw(scene, camera_, {}, kStill);
    const Image image = renderer_.read();
    double most = 0;
    for (double high = 0; high < length; high += 0.5) {
      const glm::dvec3 place = foot + high * mesh.normal(0);
      most = std::max(
          most, brightness(pixel(image, pixelOf(place))) - brightness(pixel(image, pixelOf(place + 30.0 * aside))));
    }
    return most;
  };
  EXPECT_LT(brightest(400, 20), 0.03);
  EXPECT_GT(brightest(1900, 60), 0.1) << "more dashes show that something is behind";
}

}  // namespace
}  // namespace platon::beam_painter_test
