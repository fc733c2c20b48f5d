#include "client/scene/camera_framing.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "client/scene/camera.h"
#include "tests/client/scene/surface_walk.h"

namespace platon::camera_framing_test {
namespace {

glm::dvec2 shiftAt(const SolidMesh& mesh, const Pose& player) {
  return framingShift(cameraTarget(player, mesh, 1), player.position, mesh);
}

TEST(CameraFraming, LeadsTowardsTheCentreOfTheSolid) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  EXPECT_LT(glm::length(shiftAt(mesh, mesh.pose(0, {0, 0}, 0))), 1e-9);
  const glm::dvec2 shift = shiftAt(mesh, mesh.pose(0, {100, -150}, 0));
  EXPECT_LT(shift.x, -10);
  EXPECT_GT(shift.y, 10);
}

TEST(CameraFraming, IsBoundedAndSmallOnALargeFace) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : {200.0, 480.0, 65536.0}) {
      const SolidMesh mesh(static_cast<SolidKind>(kind), size);
      const Pose player = mesh.pose(0, 0.6 * mesh.polygon()[0], 1);
      const double halfView = cameraTarget(player, mesh, 1).halfView();
      EXPECT_LE(glm::length(shiftAt(mesh, player)), kMaxFramingShift * halfView * (size > 1000 ? 0.03 : 1) + 1e-9);
    }
  }
}

TEST(CameraFraming, HasNoJumpOnAWalkOverEdges) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    SurfaceWalk walk{&mesh, 0, {0, 20}, 0.3};
    glm::dvec2 last = shiftAt(mesh, walk.pose());
    for (int step = 0; step < 3000; ++step) {
      walk.step({0.5, 0});
      const glm::dvec2 next = shiftAt(mesh, walk.pose());
      EXPECT_LT(glm::distance(last, next), 4);
      last = next;
    }
  }
}

// How far out of the middle the furthest of these points on the player's face is seen, in half pictures, wherever on
// the face the player rests.
double furthest(const SolidMesh& mesh, std::span<const glm::dvec2> points) {
  constexpr int kGrid = 12;
  double most = 0;
  Camera camera;
  for (int i = -kGrid; i <= kGrid; ++i) {
    for (int j = -kGrid; j <= kGrid; ++j) {
      const glm::dvec2 place = glm::dvec2(i, j) * (mesh.apothem() / kGrid);
      if (glm::length(place) > 0.95 * mesh.apothem()) continue;
      camera.set(mesh.pose(0, place, 0), mesh, 1280, 720);
      for (const glm::dvec2& point : points) {
        const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(mesh.toWorld(0, point), 1);
        most = std::max({most, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
      }
    }
  }
  return most;
}

TEST(CameraFraming, AFaceOfACubeIsWhollyInThePictureAtRest) {
  for (const double size : {200.0, 320.0, 480.0, 520.0}) {
    const SolidMesh mesh(SolidKind::kHexahedron, size);
    EXPECT_LT(furthest(mesh, mesh.polygon()), 0.97) << size;
  }
}

// Corners of the others may be out of the picture, and the far edge of a pentagon by a little: with all of them in it,
// the ball would be too small to play.
TEST(CameraFraming, TheEdgesOfAFaceAreInThePictureAtRest) {
  constexpr std::array<double, kSolidKinds> kLargestShipped{640, 520, 520, 356, 520};
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), kLargestShipped[static_cast<std::size_t>(kind)]);
    const auto& corners = mesh.polygon();
    std::vector<glm::dvec2> middles;
    for (std::size_t i = 0; i < corners.size(); ++i)
      middles.push_back(0.5 * (corners[i] + corners[(i + 1) % corners.size()]));
    const bool isPentagon = corners.size() == 5;
    EXPECT_LT(furthest(mesh, middles), isPentagon ? 1.09 : 1.0) << kind;
  }
}

}  // namespace
}  // namespace platon::camera_framing_test
