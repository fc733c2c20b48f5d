#include "client/scene/group_view.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "client/scene/camera_target.h"

namespace platon::group_view_test {
namespace {

constexpr double kAspect = 16.0 / 9;

SolidMesh cube() { return SolidMesh(SolidKind::kHexahedron, 480); }

// The view of the first player alone, where the group's begins.
ViewPoint ownView(const Pose& player, const SolidMesh& mesh) {
  const CameraTarget target = cameraTarget(player, mesh, 1);
  return {target.orientation, player.position + target.distance * target.back()};
}

// Follows players that stand still for so many seconds.
void follow(GroupView& group, const std::vector<Pose>& players, const SolidMesh& mesh, double seconds,
            double aspect = kAspect) {
  for (double passed = 0; passed < seconds - 1e-9; passed += 0.02)
    group.move(players, mesh, {}, 1, aspect, ownView(players[0], mesh), 0.02);
}

// Where a point is in the picture, ±1 at its borders.
glm::dvec2 seenAt(const ViewPoint& view, glm::dvec3 point, double aspect) {
  const glm::dvec3 seen = glm::conjugate(view.orientation) * (point - view.eye);
  const glm::dvec2 half = CameraTarget::kTangent * glm::max(glm::dvec2(1), glm::dvec2(aspect, 1 / aspect));
  return glm::dvec2(seen) / (-seen.z * half);
}

TEST(GroupView, ShowsAllPlayersOfOneFaceInOnePicture) {
  const SolidMesh mesh = cube();
  for (const double aspect : {kAspect, 1.0, 9.0 / 16}) {
    const std::vector<Pose> players{mesh.pose(0, {-200, -200}, 0), mesh.pose(0, {210, 150}, 0),
                                    mesh.pose(0, {0, 200}, 0.5)};
    GroupView group;
    follow(group, players, mesh, 3, aspect);
    EXPECT_TRUE(group.together());
    for (const Pose& player : players) {
      const glm::dvec2 place = glm::abs(seenAt(group.view(), player.position, aspect));
      EXPECT_LT(std::max(place.x, place.y), 0.75) << aspect;
    }
    const glm::dvec3 right = glm::cross(players[0].up, players[0].normal);
    EXPECT_NEAR(glm::dot(group.view().up(), right), 0, 0.02) << "the right of the first one is level";
  }
}

TEST(GroupView, PlayersOnOppositeFacesAreApart) {
  const SolidMesh mesh = cube();
  for (int face = 1; face < mesh.faces(); ++face) {
    const bool isOpposite = glm::dot(mesh.normal(0), mesh.normal(face)) < -0.9;
    const std::vector<Pose> players{mesh.pose(0, {0, 0}, 0), mesh.pose(face, {0, 0}, 0)};
    GroupView group;
    group.move(players, mesh, {}, 1, kAspect, ownView(players[0], mesh), 0);
    EXPECT_TRUE(!isOpposite || !group.together()) << face;
  }
}

TEST(GroupView, WhoComesTogetherAgainIsShownInOnePictureAfterTwoSeconds) {
  const SolidMesh mesh = cube();
  int opposite = 1;
  while (glm::dot(mesh.normal(0), mesh.normal(opposite)) > -0.9) ++opposite;
  const std::vector<Pose> apart{mesh.pose(0, {0, 0}, 0), mesh.pose(opposite, {0, 0}, 0)};
  const std::vector<Pose> together{mesh.pose(0, {0, 0}, 0), mesh.pose(0, {50, 0}, 0)};
  GroupView group;
  follow(group, together, mesh, 0.5);
  follow(group, apart, mesh, 0.1);
  EXPECT_FALSE(group.together());
  follow(group, together, mesh, 1.9);
  EXPECT_FALSE(group.together());
  follow(group, together, mesh, 0.2);
  EXPECT_TRUE(group.together());
}

// On all solids, for players all over: who is said to be together is seen from outside, and within the picture.
TEST(GroupView, NobodyIsHiddenOrOutOfThePictureWhileTheyAreTogether) {
  int together = 0;
  for (const SolidKind kind : {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                               SolidKind::kDodecahedron, SolidKind::kIcosahedron}) {
    const SolidMesh mesh(kind, 480);
    for (int face = 0; face < mesh.faces(); ++face) {
      for (int i = 0; i < 60; ++i) {
        const double x = 100 * (i % 3 - 1);
        const std::vector<Pose> players{mesh.pose(0, {60, -20}, 0.3), mesh.pose(face, {x, -x / 2}, 0.105 * i)};
        GroupView group;
        follow(group, players, mesh, 2);
        if (!group.together()) continue;
        ++together;
        for (const Pose& player : players) {
          const glm::dvec2 place = glm::abs(seenAt(group.view(), player.position, kAspect));
          EXPECT_LT(std::max(place.x, place.y), 0.8) << mesh.faces() << " faces, face " << face << " at " << x;
          const glm::dvec3 way = group.view().eye - player.position;
          EXPECT_GT(glm::dot(player.normal, way), (GroupView::kSlant - 0.01) * glm::length(way));
        }
      }
    }
  }
  EXPECT_GT(together, 200);
}

TEST(GroupView, WhoseDownsDifferAreApart) {
  const SolidMesh mesh = cube();
  for (double turn = -3.1; turn < 3.1; turn += 0.05) {
    const std::vector<Pose> players{mesh.pose(0, {0, 0}, 0.4), mesh.pose(0, {50, 0}, 0.4 + turn)};
    GroupView group;
    group.move(players, mesh, {}, 1, kAspect, ownView(players[0], mesh), 0);
    if (std::abs(turn) < 0.7) EXPECT_TRUE(group.together()) << turn;
    if (std::abs(turn) > 0.85) EXPECT_FALSE(group.together()) << turn;
  }
}

TEST(GroupView, JumpsToPlayersWhoAreSuddenlyElsewhereAndWithAnInstantCut) {
  const SolidMesh mesh = cube();
  int opposite = 1;
  while (glm::dot(mesh.normal(0), mesh.normal(opposite)) > -0.9) ++opposite;
  const std::vector<Pose> here{mesh.pose(0, {0, 0}, 0), mesh.pose(0, {50, 0}, 0)};
  const std::vector<Pose> there{mesh.pose(opposite, {0, 0}, 0), mesh.pose(opposite, {50, 0}, 0)};
  GroupView group;
  follow(group, here, mesh, 2);
  group.move(there, mesh, {}, 1, kAspect, ownView(there[0], mesh), 0.016);
  EXPECT_GT(glm::dot(group.view().back(), mesh.normal(opposite)), 0.8) << "not through the solid";
  CameraComfort cut;
  cut.instantCut = true;
  const std::vector<Pose> aside{mesh.pose(opposite, {-200, 0}, 0), mesh.pose(opposite, {200, 0}, 0)};
  group.move(aside, mesh, cut, 1, kAspect, ownView(aside[0], mesh), 0.016);
  const glm::dvec3 eye = group.view().eye;
  group.move(aside, mesh, cut, 1, kAspect, ownView(aside[0], mesh), 0.016);
  EXPECT_LT(glm::distance(eye, group.view().eye), 1e-9);
}

TEST(AreasOf, DividesThePictureWithoutOverlap) {
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), glm::ivec2(720, 1280), glm::ivec2(641, 479)}) {
    for (std::size_t views = 1; views <= 4; ++views) {
      const std::vector<PictureArea> areas = areasOf(views, size, 4);
      ASSERT_EQ(areas.size(), views);
      int covered = 0;
      for (std::size_t i = 0; i < views; ++i) {
        const glm::ivec2 end = areas[i].corner + areas[i].size;
        EXPECT_TRUE(end.x <= size.x && end.y <= size.y && areas[i].corner.x >= 0 && areas[i].corner.y >= 0);
        covered += areas[i].size.x * areas[i].size.y;
        for (std::size_t j = 0; j < i; ++j) {
          const glm::ivec2 other = areas[j].corner + areas[j].size;
          EXPECT_TRUE(areas[i].corner.x >= other.x + 4 || areas[j].corner.x >= end.x + 4 ||
                      areas[i].corner.y >= other.y + 4 || areas[j].corner.y >= end.y + 4);
        }
      }
      EXPECT_GE(covered, (size.x - 4) * (size.y - 4) - 8) << "all but the gaps";
    }
  }
  EXPECT_EQ(areasOf(2, {1280, 720}, 4)[1].corner, glm::ivec2(642, 0));
  EXPECT_EQ(areasOf(2, {720, 1280}, 4)[1].corner, glm::ivec2(0, 642));
  EXPECT_EQ(areasOf(3, {1280, 720}, 4)[2].size, glm::ivec2(1280, 358)) << "the third has the lower half";
  for (const PictureArea& area : areasOf(4, {1, 1}, 4)) EXPECT_TRUE(area.size.x >= 1 && area.size.y >= 1);
}

}  // namespace
}  // namespace platon::group_view_test
