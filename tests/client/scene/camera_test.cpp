#include "client/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::camera_test {
namespace {

constexpr double kSize = 480;
constexpr unsigned kSeed = 20240611;

const SolidMesh& cube() {
  static const SolidMesh mesh(SolidKind::kHexahedron, kSize);
  return mesh;
}

glm::dvec3 onScreen(const Camera& camera, glm::dvec3 point) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(point, 1);
  return glm::dvec3(clip) / clip.w;
}

Pose randomPose(const SolidMesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  const int face = static_cast<int>(random() % static_cast<unsigned>(mesh.faces()));
  const glm::dvec2 place(part(random) * mesh.apothem() * 0.35, part(random) * mesh.apothem() * 0.35);
  return mesh.pose(face, place, part(random) * 4);
}

double apart(const Camera& a, const Camera& b) {
  return glm::distance(a.eye(), b.eye()) + glm::distance(a.up(), b.up()) * a.height();
}

TEST(Camera, SetShowsThePlayerUprightInTheMiddlePart) {
  RecordProperty("seed", static_cast<int>(kSeed));
  std::mt19937 random(kSeed);
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : {200.0, kSize, 65536.0}) {
      const SolidMesh mesh(static_cast<SolidKind>(kind), size);
      for (int i = 0; i < 100; ++i) {
        const Pose player = randomPose(mesh, random);
        Camera camera;
        camera.set(player, mesh, 1280, 720);
        const glm::dvec3 middle = onScreen(camera, player.position);
        const glm::dvec3 above = onScreen(camera, player.position + player.up);
        EXPECT_LT(std::max(std::abs(middle.x) * 1280 / 720, std::abs(middle.y)), 0.31) << "seed " << kSeed;
        EXPECT_TRUE(middle.z > -1 && middle.z < 1);
        EXPECT_NEAR(above.x, middle.x, 1e-3);
        EXPECT_GT(above.y, middle.y);
        EXPECT_NEAR(camera.rollOf(player), 0, 0.01) << "level in the picture, so nearly in space";
      }
    }
  }
}

TEST(Camera, NothingIsBetweenTheCameraAndThePlayer) {
  std::mt19937 random(kSeed);
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), kSize);
    for (int i = 0; i < 100; ++i) {
      const Pose player = randomPose(mesh, random);
      Camera camera;
      camera.set(player, mesh, 640, 360);
      EXPECT_GT(glm::dot(player.normal, camera.eye() - player.position), 0) << "seed " << kSeed;
      for (int face = 0; face < mesh.faces(); ++face) {
        for (const glm::dvec2 corner : mesh.polygon())
          EXPECT_LE(onScreen(camera, mesh.toWorld(face, corner)).z, 1 + 1e-9);
      }
    }
  }
}

TEST(Camera, LerpReachesTheTarget) {
  std::mt19937 random(kSeed);
  for (int i = 0; i < 200; ++i) {
    const Pose from = randomPose(cube(), random);
    const Pose to = randomPose(cube(), random);
    Camera camera;
    camera.set(from, cube(), 1280, 720);
    for (int step = 0; step < 600; ++step) camera.lerp(to, cube(), 1.0 / 60);
    Camera wanted;
    wanted.set(to, cube(), 1280, 720);
    EXPECT_LT(apart(camera, wanted), 1e-3) << "seed " << kSeed;
  }
}

TEST(Camera, LerpDoesNotDependOnTheFrameRate) {
  std::mt19937 random(kSeed);
  for (int i = 0; i < 200; ++i) {
    const Pose from = randomPose(cube(), random);
    const Pose to = randomPose(cube(), random);
    Camera once;
    once.set(from, cube(), 1280, 720);
    once.lerp(to, cube(), 0);  // it has come there, and stands still
    Camera often = once;
    once.lerp(to, cube(), 0.1);
    for (int step = 0; step < 10; ++step) often.lerp(to, cube(), 0.01);
    EXPECT_LT(apart(once, often), 1e-6) << "seed " << kSeed;
  }
}

TEST(Camera, LerpDoesNotDependOnTheFrameRateAfterARun) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < 100; ++i) {
    Camera once;
    once.set(cube().pose(0, {0, 0}, 0), cube(), 1280, 720);
    const glm::dvec2 step(3.2 * part(random), 5 * part(random));
    for (int tick = 1; tick < 55; ++tick) once.lerp(cube().pose(0, step * (1.0 * tick), 0), cube(), 1.0 / 60);
    const Pose player = cube().pose(0, step * 54.0, part(random));
    Camera often = once;
    once.lerp(player, cube(), 0.7);
    for (int frame = 0; frame < 70; ++frame) often.lerp(player, cube(), 0.01);
    EXPECT_LT(apart(once, often), 1e-6) << "seed " << kSeed;
  }
}

TEST(Camera, AShownViewDoesNotAffectTheNextLerp) {
  const Pose player = cube().pose(0, {10, 20}, 0.3);
  Camera camera;
  camera.set(player, cube(), 1280, 720);
  const Camera before = camera;
  camera.show({{1, 0, 0, 0}, {0, 0, 3000}});
  EXPECT_EQ(camera.eye(), glm::dvec3(0, 0, 3000));
  EXPECT_EQ(camera.rollOf(player), before.rollOf(player));
  camera.lerp(player, cube(), 0.1);
  EXPECT_LT(apart(camera, before), 1e-9);
}

// Without a roll, the angle between the camera and its target falls by the factor e each 1/14 s.
TEST(Camera, FollowsThePlayerAtARateOf14PerSecond) {
  const Pose from = cube().pose(0, {0, 0}, 0);
  const Pose to = cube().pose(0, {0, 100}, 0);
  const auto angleTo = [](const Camera& camera, const Camera& target) {
    return std::acos(glm::dot(camera.back(), target.back()));
  };
  Camera camera;
  camera.set(from, cube(), 1280, 720);
  Camera target;
  target.set(to, cube(), 1280, 720);
  camera.lerp(to, cube(), 0);  // the player has come there
  const double before = angleTo(camera, target);
  camera.lerp(to, cube(), 0.05);
  EXPECT_NEAR(angleTo(camera, target), before * std::exp(-14 * 0.05), 1e-9);
}

TEST(Camera, LerpByZeroSecondsChangesNothing) {
  std::mt19937 random(kSeed);
  Camera camera;
  camera.set(randomPose(cube(), random), cube(), 1280, 720);
  const Camera before = camera;
  camera.lerp(randomPose(cube(), random), cube(), 0);
  EXPECT_LT(apart(camera, before), 1e-9);
}

// A fast run over an edge: the camera turns continuously although the normal of the face jumps.
TEST(Camera, CrossingAnEdgeTurnsContinuously) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), kSize);
    const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(0, 0);
    Camera camera;
    const double along = mesh.faceSize() * 0.2;
    for (int step = -40; step <= 40; ++step) {
      const double beyond = step * 5.0;
      const glm::dvec2 here = mesh.edgeNormals()[0] * (mesh.apothem() + beyond) + glm::dvec2(along, 0);
      const glm::dvec2 there(glm::inverse(mesh.unfolded(0, 0)) * glm::dvec4(here, 0, 1));
      const Pose player = beyond < 0 ? mesh.pose(0, here, 1) : mesh.pose(next.face, there, 1 + toRadians(next.turn));
      if (step == -40) camera.set(player, mesh, 1280, 720);
      const Camera before = camera;
      camera.lerp(player, mesh, 1.0 / 60);
      EXPECT_LT(glm::distance(camera.up(), before.up()), 0.12);
      EXPECT_LT(glm::distance(camera.back(), before.back()), 0.14);
      const glm::dvec3 seen = onScreen(camera, player.position);
      EXPECT_LT(glm::length(glm::dvec2(seen)), Camera::kMiddle) << "kind " << kind << " step " << step;
    }
  }
}

TEST(Camera, OppositeDirectionsGiveAFiniteOrientation) {
  for (const double seconds : {0.0, 1e-9, 1.0 / 60, 10.0, 1e9}) {
    for (const double angle : {0.0, 1.0, 3.141592653589793}) {
      Camera camera;
      const Pose here = cube().pose(0, {0, 0}, 0);
      Pose opposite = here;
      opposite.position = -here.position;
      opposite.normal = -here.normal;
      opposite.up = glm::angleAxis(angle, here.normal) * here.up;
      camera.set(here, cube(), 1280, 720);
      for (int step = 0; step < 100; ++step) {
        camera.lerp(opposite, cube(), seconds);
        EXPECT_TRUE(std::isfinite(camera.eye().x + camera.eye().y + camera.eye().z + camera.up().x));
        EXPECT_NEAR(glm::length(camera.up()), 1, 1e-9);
        EXPECT_NEAR(glm::dot(camera.up(), camera.back()), 0, 1e-9);
      }
    }
  }
}

TEST(Camera, AnUpAlongTheLineOfSightGivesAFiniteOrientation) {
  Pose player = cube().pose(2, {10, 20}, 0);
  player.up = glm::normalize(player.position);
  Camera camera;
  camera.set(player, cube(), 1280, 720);
  EXPECT_NEAR(glm::length(camera.up()), 1, 1e-9);
  camera.lerp(player, cube(), 0.1);
  EXPECT_TRUE(std::isfinite(camera.up().x + camera.rollOf(player)));
}

TEST(Camera, InstantCutEqualsSet) {
  std::mt19937 random(kSeed);
  Camera camera;
  camera.set(randomPose(cube(), random), cube(), 1280, 720);
  camera.setComfort({.turnRate = 7, .instantCut = true, .reducedMotion = false});
  const Pose player = randomPose(cube(), random);
  camera.lerp(player, cube(), 0);
  Camera wanted;
  wanted.set(player, cube(), 1280, 720);
  EXPECT_LT(apart(camera, wanted), 1e-9);
}

TEST(Camera, JumpsToAPlayerWhoIsFarAway) {
  const Pose there = cube().pose(0, {-200, 200}, 1);
  for (const Pose& here : {cube().pose(0, {200, -200}, 0), cube().pose(5, {0, 0}, 0)}) {
    Camera camera;
    camera.set(here, cube(), 1280, 720);
    camera.lerp(there, cube(), 0.001);
    Camera wanted;
    wanted.set(there, cube(), 1280, 720);
    EXPECT_LT(apart(camera, wanted), 1e-9);
  }
}

TEST(Camera, TheCameraOfAFaceStandsStillUntilAnEdge) {
  Camera camera;
  camera.setComfort({.view = CameraView::kFace});
  camera.set(cube().pose(0, {0, 0}, 0), cube(), 1280, 720);
  const Camera before = camera;
  camera.lerp(cube().pose(0, {200, 200}, 0), cube(), 1);
  EXPECT_EQ(apart(camera, before), 0);
  camera.lerp(cube().pose(1, {200, 200}, 0), cube(), 0);
  EXPECT_NEAR(glm::dot(camera.back(), cube().normal(1)), 1, 1e-12);
}

TEST(Camera, ReducedMotionBoundsTheRoll) {
  Camera camera;
  camera.set(cube().pose(0, {0, 0}, 0), cube(), 1280, 720);
  camera.setComfort({.turnRate = 30, .instantCut = false, .reducedMotion = true});
  const Pose turned = cube().pose(0, {0, 0}, 1.5);
  for (int step = 0; step < 60; ++step) {
    const double before = camera.rollOf(turned);
    camera.lerp(turned, cube(), 1.0 / 60);
    EXPECT_LE(before - camera.rollOf(turned), Camera::kSlowRoll / 60 + 1e-9);
    EXPECT_GT(before - camera.rollOf(turned), 0);
  }
}

TEST(Camera, AGreaterTurnSpeedRollsFaster) {
  const Pose turned = cube().pose(0, {0, 0}, 1.5);
  double last = 1.5;
  for (const double speed : {1.0, 5.0, 20.0}) {
    Camera camera;
    camera.set(cube().pose(0, {0, 0}, 0), cube(), 1280, 720);
    camera.setComfort({.turnRate = speed, .instantCut = false, .reducedMotion = false});
    camera.lerp(turned, cube(), 0.1);
    EXPECT_LT(camera.rollOf(turned), last);
    last = camera.rollOf(turned);
  }
}

TEST(Camera, ZoomMagnifies) {
  const Pose player = cube().pose(0, {0, 0}, 0);
  Camera camera;
  camera.set(player, cube(), 1280, 720);
  const double before = onScreen(camera, player.position + player.up).y;
  camera.setZoom(2);
  camera.set(player, cube(), 1280, 720);
  EXPECT_NEAR(onScreen(camera, player.position + player.up).y / before, 2, 1e-6);
}

TEST(Camera, ThePlacedCameraIsWhereItWasPut) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  Camera camera;
  camera.resize(640, 480);
  camera.place({0, 0, 1500}, {1, 0, 0}, mesh);
  EXPECT_LT(glm::distance(camera.eye(), glm::dvec3(0, 0, 1500)), 1e-9);
  EXPECT_LT(glm::distance(camera.up(), glm::dvec3(1, 0, 0)), 1e-9);
  EXPECT_EQ(camera.width(), 640U);
}

}  // namespace
}  // namespace platon::camera_test
