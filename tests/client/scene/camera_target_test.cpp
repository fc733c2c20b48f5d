#include "client/scene/camera_target.h"

#include <cmath>
#include <cstddef>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/client/scene/surface_walk.h"

namespace platon::camera_target_test {
namespace {

constexpr unsigned kSeed = 20261123;

double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

template <class Check>
void forEverySolid(Check check) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : {200.0, 480.0, 2000.0, 65536.0}) check(SolidMesh(static_cast<SolidKind>(kind), size));
  }
}

// The point of edge 0 of face 0, `part` of half the edge from its middle, and moved by `inwards` into the face.
glm::dvec2 nearEdge(const SolidMesh& mesh, double part, double inwards) {
  return glm::dvec2(part * mesh.faceSize() / 2, 0) + mesh.edgeNormals()[0] * (mesh.apothem() - inwards);
}

TEST(CameraTarget, ShowsAFaceFromTheFrontInItsMiddlePart) {
  forEverySolid([](const SolidMesh& mesh) {
    const double depth = std::min(CameraTarget::kEdgeZone, mesh.apothem() / 2);
    for (int face = 0; face < mesh.faces(); ++face) {
      for (const double distance : {0.0, 0.5, 0.99}) {
        const glm::dvec3 place = mesh.toWorld(face, glm::dvec2(0, -1) * (mesh.apothem() - depth) * distance);
        EXPECT_LT(angleBetween(roundedNormal(mesh, place), mesh.normal(face)), 1e-6);
        const CameraTarget target = cameraTarget(mesh.pose(face, {0, 0}, 0.3), mesh, 1);
        EXPECT_LT(angleBetween(target.back(), mesh.normal(face)), 1e-6);
      }
    }
  });
}

TEST(CameraTarget, AtTheMiddleOfAnEdgeAndAtACornerItIsOnTheRay) {
  forEverySolid([](const SolidMesh& mesh) {
    for (const double part : {0.0, 1.0}) {
      const glm::dvec3 place = mesh.toWorld(0, nearEdge(mesh, part, 0));
      EXPECT_LT(angleBetween(roundedNormal(mesh, place), place), 1e-6);
    }
  });
}

TEST(CameraTarget, HasNoJumpAtAnEdge) {
  forEverySolid([](const SolidMesh& mesh) {
    const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(0, 0);
    for (double part = -0.999; part < 1; part += 0.111) {
      const glm::dvec2 here = nearEdge(mesh, part, 0);
      const glm::dvec2 there(glm::inverse(mesh.unfolded(0, 0)) * glm::dvec4(here, 0, 1));
      const CameraTarget before = cameraTarget(mesh.pose(0, here, 0.7), mesh, 1);
      const CameraTarget after = cameraTarget(mesh.pose(next.face, there, 0.7 + toRadians(next.turn)), mesh, 1);
      EXPECT_GT(std::abs(glm::dot(before.orientation, after.orientation)), 1 - 1e-6) << part;
    }
  });
}

// In a zone of 60 level units the view turns by half the angle between two faces.
TEST(CameraTarget, TurnsEvenlyWithTheWay) {
  forEverySolid([](const SolidMesh& mesh) {
    const double zone = std::min(CameraTarget::kEdgeZone, mesh.apothem() / 2);
    const double turn = std::acos(-1.0) - mesh.dihedral();
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> part(-1, 1);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec2 here = nearEdge(mesh, part(random) * 0.9, (part(random) + 1) * zone);
      const glm::dvec2 step = zone / 100 * glm::normalize(glm::dvec2(part(random), part(random)));
      const glm::dvec3 before = roundedNormal(mesh, mesh.onSurface(mesh.toWorld(0, here)));
      const glm::dvec3 after = roundedNormal(mesh, mesh.onSurface(mesh.toWorld(0, here + step)));
      EXPECT_LT(angleBetween(before, after), 3 * turn / 100) << "seed " << kSeed;
    }
  });
}

TEST(CameraTarget, ThePlayersRightIsLevelOnTheScreen) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> part(-1, 1);
  forEverySolid([&](const SolidMesh& mesh) {
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 place = mesh.apothem() / 2 * glm::dvec2(0, 1) * part(random);
      const Pose player = mesh.pose(i % mesh.faces(), place, i);
      const glm::dvec3 right =
          glm::conjugate(cameraTarget(player, mesh, 1).orientation) * glm::cross(player.up, player.normal);
      EXPECT_NEAR(right.y, 0, 1e-9);
      EXPECT_GT(right.x, 0.9);
    }
  });
}

// Round a corner, the player's right turns on the screen by what lacks of a full turn.
TEST(CameraTarget, HasNoJumpRoundACorner) {
  forEverySolid([](const SolidMesh& mesh) {
    SurfaceWalk walk{&mesh, 0, mesh.polygon()[0] * (1 - 20 / glm::length(mesh.polygon()[0])), 0};
    double direction = 1;
    CameraTarget last = cameraTarget(walk.pose(), mesh, 1);
    for (int step = 0; step < 4000; ++step) {
      direction += 0.1 / 20;
      walk.step(0.1 * glm::dvec2(std::cos(direction), std::sin(direction)));
      const CameraTarget next = cameraTarget(walk.pose(), mesh, 1);
      EXPECT_GT(std::abs(glm::dot(last.orientation, next.orientation)), 0.98) << "step " << step;
      last = next;
    }
  });
}

TEST(CameraTarget, ShowsAUsefulPartOfAFaceOfAnySize) {
  forEverySolid([](const SolidMesh& mesh) {
    const double view = 2 * cameraTarget(mesh.pose(0, {0, 0}, 0), mesh, 1).halfView();
    EXPECT_GE(view, 460 - 1e-9);
    EXPECT_LE(view, 760 + 1e-9);
    EXPECT_NEAR(cameraTarget(mesh.pose(0, {0, 0}, 0), mesh, 2).halfView(), view / 4, 1e-9);
  });
}

}  // namespace
}  // namespace platon::camera_target_test
