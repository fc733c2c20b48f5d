#include "client/scene/camera_target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/scene/camera.h"
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

// With two humps, the picture would nod twice at each edge.
TEST(CameraTarget, OnAWayOverAnEdgeItTurnsFastestAtTheEdge) {
  forEverySolid([](const SolidMesh& mesh) {
    const double step = std::min(CameraTarget::kEdgeZone, mesh.apothem() / 2) / 50;
    const auto turnAt = [&](double inwards) {
      const glm::dvec3 before = mesh.onSurface(mesh.toWorld(0, nearEdge(mesh, 0, inwards + step / 2)));
      const glm::dvec3 after = mesh.onSurface(mesh.toWorld(0, nearEdge(mesh, 0, inwards - step / 2)));
      return angleBetween(roundedNormal(mesh, before), roundedNormal(mesh, after));
    };
    double last = turnAt(step);
    for (double inwards = 2 * step; inwards < 49 * step; inwards += step) {
      EXPECT_LE(turnAt(inwards), last * (1 + 1e-6)) << inwards;
      last = turnAt(inwards);
    }
    EXPECT_GT(last, 0.3 * turnAt(step));
  });
}

// If the picture depended on the player's up, it would roll in another way in each direction of a corner.
TEST(CameraTarget, TurnsWithThePlayersUpEverywhere) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> part(-1, 1);
  forEverySolid([&](const SolidMesh& mesh) {
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 place = mesh.apothem() * glm::dvec2(part(random), part(random)) * 0.7;
      const double turn = 3 * part(random);
      const CameraTarget before = cameraTarget(mesh.pose(i % mesh.faces(), place, i), mesh, 1);
      const CameraTarget after = cameraTarget(mesh.pose(i % mesh.faces(), place, i + turn), mesh, 1);
      const glm::dquat turned = glm::angleAxis(turn, before.back()) * before.orientation;
      EXPECT_NEAR(std::abs(glm::dot(turned, after.orientation)), 1, 1e-9) << "seed " << kSeed;
    }
  });
}

TEST(CameraTarget, InTheMiddlePartThePlayersRightIsNearlyLevelOnTheScreen) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> part(-1, 1);
  forEverySolid([&](const SolidMesh& mesh) {
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 place = mesh.apothem() / 2 * glm::dvec2(0, 1) * part(random);
      const Pose player = mesh.pose(i % mesh.faces(), place, i);
      const glm::dvec3 right =
          glm::conjugate(cameraTarget(player, mesh, 1).orientation) * glm::cross(player.up, player.normal);
      EXPECT_NEAR(right.y, 0, 0.04);
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

constexpr double kTick = 1.0 / 60;
constexpr double kRun = 3.2;     // level units a tick
constexpr double kAtOnce = 1e9;  // a rate at which a point follows at once

Pose poseAt(double right, double up) { return {{right, up, 100}, {0, 1, 0}, {0, 0, 1}}; }

// The look-ahead now.
glm::dvec2 aheadOf(const LookAhead& lookAhead, bool reduced = false) {
  return lookAhead.followed(kAtOnce, 1e-7, reduced);
}

struct Walk {
  LookAhead lookAhead;
  glm::dvec2 place{0};

  Walk() { lookAhead.reset(poseAt(0, 0)); }
  void step(glm::dvec2 way) {
    place += way;
    lookAhead.move(poseAt(place.x, place.y));
    lookAhead.wait(kTick);
  }
};

TEST(LookAhead, LeadsWhoRunsOn) {
  for (const double direction : {-1.0, 1.0}) {
    Walk walk;
    double last = 0;
    for (int tick = 0; tick < 120; ++tick) {
      walk.step({direction * kRun, 0});
      const double lookAhead = direction * aheadOf(walk.lookAhead).x;
      EXPECT_GE(lookAhead, last - 1e-6);
      EXPECT_LE(lookAhead - last, kRun) << "the picture never overtakes the player by more than the player runs";
      last = lookAhead;
    }
    EXPECT_NEAR(last, LookAhead::kMax, 6);
  }
}

TEST(LookAhead, SmallTurnsDoNotMoveIt) {
  Walk walk;
  for (int tick = 0; tick < 600; ++tick) {
    walk.step({tick / 8 % 2 == 0 ? kRun : -kRun, 0});
    EXPECT_NEAR(aheadOf(walk.lookAhead).x, 0, 1e-3);
  }
}

// A jump of 60 level units in 24 ticks each way.
TEST(LookAhead, InAJumpThePictureMovesLessThanThePlayer) {
  Walk walk;
  double highest = 0;
  for (int tick = 0; tick < 48; ++tick) {
    const double height = 60 * (1 - std::pow((tick + 1 - 24) / 24.0, 2));
    walk.step({0, height - walk.place.y});
    const double shown = walk.place.y + aheadOf(walk.lookAhead).y;
    highest = std::max(highest, shown);
    EXPECT_GE(shown, -12);
  }
  EXPECT_LT(highest, 35);
}

TEST(LookAhead, LeadsALongFall) {
  Walk walk;
  for (int tick = 0; tick < 90; ++tick) walk.step({0, -5.5});
  EXPECT_LT(aheadOf(walk.lookAhead).y, -50);
  EXPECT_GE(aheadOf(walk.lookAhead).y, -LookAhead::kMax);
}

TEST(LookAhead, WithReducedMotionNothingLeadsThePlayer) {
  Walk walk;
  for (int tick = 0; tick < 90; ++tick) walk.step({kRun, -5.5});
  EXPECT_NEAR(aheadOf(walk.lookAhead, true).x, 0, 1e-3);
  EXPECT_GE(aheadOf(walk.lookAhead, true).y, 0);
}

TEST(LookAhead, GoesBackWhenThePlayerStands) {
  Walk walk;
  for (int tick = 0; tick < 90; ++tick) walk.step({kRun, -5.5});
  walk.lookAhead.wait(5);
  EXPECT_NEAR(aheadOf(walk.lookAhead).x, 0, 1e-3);
  EXPECT_NEAR(aheadOf(walk.lookAhead).y, 0, 0.2);
}

// The closed solution against small steps of the differential equation.
TEST(LookAhead, TheFollowingPointSolvesItsEquation) {
  constexpr double kRate = 14;
  for (const glm::dvec2 way : {glm::dvec2(20, 10), glm::dvec2(45, -60), glm::dvec2(-200, 200)}) {
    LookAhead lookAhead;
    lookAhead.reset(poseAt(0, 0));
    lookAhead.move(poseAt(way.x, way.y));
    LookAhead now = lookAhead;
    glm::dvec2 place(0);
    constexpr int kSteps = 200000;
    constexpr double kStep = 2.0 / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      place += (aheadOf(now) - place) * kRate * kStep;
      now.wait(kStep);
    }
    const glm::dvec2 solved = lookAhead.followed(kRate, 2, false);
    EXPECT_NEAR(solved.x, place.x, 0.01);
    EXPECT_NEAR(solved.y, place.y, 0.01);
  }
}

TEST(LookAhead, IsCarriedOverAnEdge) {
  LookAhead lookAhead;
  lookAhead.reset(poseAt(0, 0));
  lookAhead.move(poseAt(125, 0));
  const glm::dvec2 before = aheadOf(lookAhead);
  lookAhead.move({{125, 0, 100}, {0, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(aheadOf(lookAhead), before);
}

// Distance of a place from the middle of the picture, in half shorter sides.
double outwards(const ViewPoint& view, glm::dvec3 place) {
  const glm::dvec3 seen = glm::conjugate(view.orientation) * (place - view.eye);
  return std::max(std::abs(seen.x), std::abs(seen.y)) / -seen.z / CameraTarget::kTangent;
}

TEST(FaceHold, StandsStillAndShowsTheWholeFace) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const SolidMesh mesh(static_cast<SolidKind>(kind), 480);
    FaceHold hold;
    const ViewPoint first = hold.view(mesh.pose(0, {0, 0}, 1), mesh, 1);
    EXPECT_NEAR(glm::dot(first.back(), mesh.normal(0)), 1, 1e-12);
    for (const glm::dvec2 corner : mesh.polygon()) {
      EXPECT_EQ(hold.view(mesh.pose(0, corner, 1), mesh, 1).eye, first.eye);
      EXPECT_LT(outwards(first, mesh.toWorld(0, corner)), 0.9);
    }
  }
}

TEST(FaceHold, CutsToTheNextFaceWithThePlayerUpright) {
  const SolidMesh mesh(SolidKind::kTetrahedron, 480);
  FaceHold hold;
  hold.view(mesh.pose(0, {0, 0}, 0), mesh, 1);
  const Pose player = mesh.pose(2, {10, 10}, 2.5);
  const ViewPoint view = hold.view(player, mesh, 1);
  EXPECT_NEAR(glm::dot(view.back(), player.normal), 1, 1e-12);
  EXPECT_NEAR(glm::dot(view.up(), player.up), 1, 1e-12);
  const Pose turned = mesh.pose(2, {10, 10}, 1);
  EXPECT_NEAR(glm::dot(hold.view(turned, mesh, 1).up(), turned.up), 1, 1e-12);
}

TEST(FaceHold, OnALargeFaceThePlayerStaysAwayFromTheBorder) {
  const SolidMesh mesh(SolidKind::kHexahedron, 65536);
  FaceHold hold;
  SurfaceWalk walk{&mesh, 0, {0, 0}, 0};
  glm::dvec3 last = hold.view(walk.pose(), mesh, 1).eye;
  int cuts = 0;
  for (int tick = 0; tick < 3000; ++tick) {
    walk.step({3.2, 1});
    const ViewPoint view = hold.view(walk.pose(), mesh, 1);
    EXPECT_LT(outwards(view, walk.pose().position), 0.71);
    cuts += view.eye != last ? 1 : 0;
    last = view.eye;
  }
  EXPECT_GT(cuts, 20);
  EXPECT_LT(cuts, 60);
}

TEST(FaceHold, ZoomMagnifies) {
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  const Pose player = mesh.pose(0, {30, 0}, 0);
  FaceHold hold;
  const double far = glm::length(hold.view(player, mesh, 1).eye) - mesh.inradius();
  EXPECT_NEAR(glm::length(hold.view(player, mesh, 0.5).eye) - mesh.inradius(), 2 * far, 1e-6);
  EXPECT_LT(glm::length(hold.view(player, mesh, 2).eye), far);
}

}  // namespace

}  // namespace platon::camera_target_test
