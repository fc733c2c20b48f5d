#include "client/menu/pages/turntable.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace platon::turntable_test {
namespace {

// Where a point of the solid is in the picture, -1 … 1.
glm::dvec2 placeIn(const Camera& camera, glm::dvec3 point) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(point, 1);
  return glm::dvec2(clip) / clip.w;
}

class TurntableTest : public testing::Test {
 protected:
  TurntableTest() {
    const LevelResult result = loadLevel("TETRAHEDRON\n0 0 0 0\n0 20 0\n480\n%\n-30 -20 30 -20\n%\n%\n%\n");
    turntable_.show(result.level);
  }

  Turntable turntable_;
};

TEST_F(TurntableTest, ShowsTheLevelWithoutPlayers) {
  EXPECT_TRUE(turntable_.shows());
  EXPECT_FALSE(Turntable().shows());
  EXPECT_TRUE(turntable_.scene().players.empty());
}

TEST_F(TurntableTest, TheWholeSolidIsInThePictureAsItTurns) {
  const SolidMesh& mesh = turntable_.scene().stage->mesh;
  for (int second = 0; second < 45; ++second) {
    turntable_.advance(1);
    for (const auto& [w, h] : {std::pair(1280U, 720U), {720U, 720U}, {400U, 900U}, {2520U, 1080U}}) {
      const Camera camera = turntable_.camera(w, h);
      for (int face = 0; face < mesh.faces(); ++face) {
        for (const glm::dvec2 corner : mesh.polygon()) {
          const glm::dvec2 place = placeIn(camera, mesh.toWorld(face, corner));
          EXPECT_LT(std::abs(place.x), 1) << w << " × " << h;
          EXPECT_LT(std::abs(place.y), 1) << w << " × " << h;
        }
      }
    }
  }
}

TEST_F(TurntableTest, InAWidePictureTheSolidIsAtTheRight) {
  EXPECT_NEAR(placeIn(turntable_.camera(1280, 720), {0, 0, 0}).x, 0.42, 1e-9);
  EXPECT_NEAR(placeIn(turntable_.camera(720, 720), {0, 0, 0}).x, 0, 1e-9);
}

TEST_F(TurntableTest, TurnsRoundIn40Seconds) {
  const glm::dvec3 before = turntable_.camera(1280, 720).back();
  turntable_.advance(20);
  EXPECT_GT(glm::distance(turntable_.camera(1280, 720).back(), before), 1);
  turntable_.advance(20);
  EXPECT_LT(glm::distance(turntable_.camera(1280, 720).back(), before), 1e-9);
}

}  // namespace
}  // namespace platon::turntable_test
