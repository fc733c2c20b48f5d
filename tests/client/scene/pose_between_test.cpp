#include "client/scene/pose_between.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace platon::pose_between_test {
namespace {

constexpr double kSize = 480;
constexpr double kLattice = 2.0 / kSubunitsPerUnit;  // error from rounding both ends to subunits
constexpr double kNear = 6;
constexpr int kSteps = 40;

double draw(std::mt19937_64& random, double from, double to) {
  return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Point toSubunits(glm::dvec2 point) {
  return {static_cast<std::int32_t>(std::lround(point.x * kSubunitsPerUnit)),
          static_cast<std::int32_t>(std::lround(point.y * kSubunitsPerUnit))};
}

bool isOnSurface(const SolidMesh& mesh, glm::dvec3 point) {
  return std::abs(glm::dot(mesh.normal(mesh.faceTowards(point)), point) - mesh.inradius()) < 1e-6;
}

PlayerSnapshot standing(int face, glm::dvec2 point, Angle angle) {
  return {static_cast<std::uint32_t>(face), toSubunits(point), angle, 0, true};
}

// The path of one tick over an edge.
struct Crossing {
  InterpolatedPlayer player;
  int face = 0;
  int edge = 0;
};

class PoseBetweenTest : public testing::TestWithParam<int> {
 protected:
  // Crosses `edge` of `face` at distance `along` from its middle and angle `slant` from its normal. The path is
  // `length` units long; the part `share` of it lies on `face`.
  Crossing crossing(int face, int edge, double along, double slant, double length, double share) const {
    const glm::dvec2 out = mesh_.edgeNormals()[static_cast<std::size_t>(edge)];
    const glm::dvec2 side(-out.y, out.x);
    const glm::dvec2 over = out * mesh_.apothem() + side * along;
    const glm::dvec2 direction = out * std::cos(slant) + side * std::sin(slant);
    const glm::dvec4 beyond(over + direction * length * (1 - share), 0, 1);
    const PlatonicSolid::Neighbour& next = mesh_.solid().neighbour(face, edge);
    const Angle up = Angle(face * 1700 + edge * 4300);
    Crossing result{{}, face, edge};
    result.player.before = standing(face, over - direction * length * share, up);
    result.player.now =
        standing(next.face, glm::dvec2(glm::inverse(mesh_.unfolded(face, edge)) * beyond), up + next.turn);
    return result;
  }

  // A pose in the frame of the edge: x along the edge, y across it, > 0 beyond it. Computed from the coordinates in
  // space only.
  struct FromEdge {
    glm::dvec2 place;
    glm::dvec2 up;
  };
  FromEdge fromEdge(const Crossing& crossing, const Pose& pose) const {
    const auto corner = static_cast<std::size_t>(crossing.edge);
    const glm::dvec3 a = mesh_.toWorld(crossing.face, mesh_.polygon()[corner]);
    const glm::dvec3 b = mesh_.toWorld(crossing.face, mesh_.polygon()[(corner + 1) % mesh_.polygon().size()]);
    const glm::dvec3 along = glm::normalize(b - a);
    const glm::dvec3 across = glm::cross(along, pose.normal);
    return {{glm::dot(pose.position - a, along), glm::dot(pose.position - a, across)},
            {glm::dot(pose.up, along), glm::dot(pose.up, across)}};
  }

  // The interpolated path is linear in the unfolded faces and on the surface; up does not turn.
  void checkCrossing(Crossing crossing) const {
    crossing.player.fraction = 0;
    const FromEdge first = fromEdge(crossing, poseBetween(mesh_, crossing.player));
    crossing.player.fraction = 1;
    const FromEdge last = fromEdge(crossing, poseBetween(mesh_, crossing.player));
    ASSERT_LT(first.place.y, 0);
    ASSERT_GT(last.place.y, 0);
    for (int step = 0; step <= kSteps; ++step) {
      crossing.player.fraction = double{1} * step / kSteps;
      const Pose pose = poseBetween(mesh_, crossing.player);
      const FromEdge now = fromEdge(crossing, pose);
      EXPECT_TRUE(isOnSurface(mesh_, pose.position));
      EXPECT_LT(glm::distance(now.place, glm::mix(first.place, last.place, crossing.player.fraction)), 1e-6);
      const int face = now.place.y < 0 ? crossing.face : static_cast<int>(crossing.player.now.part);
      EXPECT_TRUE(pose.normal == mesh_.normal(face) || std::abs(now.place.y) < 1e-6);
      EXPECT_LT(glm::distance(now.up, first.up), 1e-6);
      EXPECT_NEAR(glm::length(pose.up), 1, 1e-9);
    }
  }

  std::pair<int, int> commonCorner(int face, int other) const {
    const PlatonicSolid& solid = mesh_.solid();
    for (int a = 0; a < solid.edgesPerFace(); ++a) {
      for (int b = 0; b < solid.edgesPerFace(); ++b) {
        if (solid.vertex(face, a) == solid.vertex(other, b)) return {a, b};
      }
    }
    return {-1, -1};
  }

  // A random player on the face, within kNear units of its corner.
  PlayerSnapshot nearCorner(std::mt19937_64& random, int face, int corner) const {
    while (true) {
      const glm::dvec2 offset(draw(random, -kNear, kNear), draw(random, -kNear, kNear));
      const glm::dvec2 point = mesh_.polygon()[static_cast<std::size_t>(corner)] + offset;
      const auto outside = [&](glm::dvec2 normal) { return glm::dot(normal, point) > mesh_.apothem() - kLattice; };
      const auto& normals = mesh_.edgeNormals();
      if (glm::length(offset) < kNear && std::none_of(normals.begin(), normals.end(), outside)) {
        return standing(face, point, Angle(static_cast<std::int32_t>(random() % Angle::kTurn)));
      }
    }
  }

  void checkPath(InterpolatedPlayer player) const {
    constexpr int kFineSteps = 200;
    Pose last = poseOf(mesh_, player.before);
    for (int step = 0; step <= kFineSteps; ++step) {
      player.fraction = double{1} * step / kFineSteps;
      const Pose pose = poseBetween(mesh_, player);
      EXPECT_TRUE(isOnSurface(mesh_, pose.position));
      // The projection from the centre stretches a distance at most three times.
      EXPECT_LT(glm::distance(pose.position, last.position), 4 * 2 * kNear / kFineSteps);
      EXPECT_NEAR(glm::dot(pose.up, pose.normal), 0, 1e-9);
      EXPECT_NEAR(glm::length(pose.up), 1, 1e-9);
      last = pose;
    }
    EXPECT_LT(glm::distance(last.position, poseOf(mesh_, player.now).position), 1e-6);
  }

  SolidMesh mesh_{static_cast<SolidKind>(GetParam()), kSize};
};

TEST_P(PoseBetweenTest, APathOverAnEdgeIsLinearInTheUnfoldedFaces) {
  for (int face = 0; face < mesh_.faces(); ++face) {
    for (int edge = 0; edge < mesh_.solid().edgesPerFace(); ++edge) {
      std::mt19937_64 random(static_cast<std::uint64_t>(face * 8 + edge));
      for (int i = 0; i < 20; ++i) {
        const double length = i % 2 == 0 ? 3.2 : 24;  // a run, and more than the fastest fall
        SCOPED_TRACE("face " + std::to_string(face) + " edge " + std::to_string(edge) + " path " + std::to_string(i));
        checkCrossing(
            crossing(face, edge, draw(random, -200, 200), draw(random, -1, 1), length, draw(random, 0.05, 0.95)));
        if (HasFailure()) return;
      }
    }
  }
}

TEST_P(PoseBetweenTest, FractionsZeroAndOneAreTheEnds) {
  for (const double share : {0.1, 0.5, 0.9}) {
    InterpolatedPlayer player = crossing(1, 1, 30, 0.5, 12, share).player;
    for (const double fraction : {0.0, 1.0}) {
      player.fraction = fraction;
      const Pose drawn = poseBetween(mesh_, player);
      const Pose stands = poseOf(mesh_, fraction < 1 ? player.before : player.now);
      EXPECT_LT(glm::distance(drawn.position, stands.position), 1e-6);
      EXPECT_LT(glm::distance(drawn.up, stands.up), 1e-6);
      EXPECT_EQ(drawn.normal, stands.normal);
    }
  }
}

// The two faces need not have a common edge, and the straight path may miss it.
TEST_P(PoseBetweenTest, APathRoundAVertexStaysOnTheSurfaceAndDoesNotJump) {
  std::mt19937_64 random(1);
  for (int face = 0; face < mesh_.faces(); ++face) {
    for (int other = 0; other < mesh_.faces(); ++other) {
      for (int i = 0; i < 5; ++i) {
        const auto [corner, otherCorner] = commonCorner(face, other);
        if (corner < 0 || face == other) continue;
        SCOPED_TRACE("from " + std::to_string(face) + " to " + std::to_string(other));
        checkPath({nearCorner(random, face, corner), nearCorner(random, other, otherCorner), 0});
      }
    }
  }
}

TEST_P(PoseBetweenTest, TheUpDirectionTurnsLinearlyWithinAFace) {
  const PlayerSnapshot before = standing(2, {10, 20}, Angle(1000));
  const PlayerSnapshot now = standing(2, {14, 20}, Angle(5000));
  const Pose middle = poseBetween(mesh_, {before, now, 0.5});
  const Pose expected = mesh_.pose(2, {12, 20}, toRadians(Angle(3000)));
  EXPECT_LT(glm::distance(middle.position, expected.position), kLattice);
  EXPECT_LT(glm::distance(middle.up, expected.up), 1e-9);
}

TEST_P(PoseBetweenTest, ADistanceTooLongForOneTickIsAJump) {
  const PlayerSnapshot before = standing(0, {0, 0}, Angle());
  const auto drawnAt = [&](double distance) {
    const PlayerSnapshot now = standing(0, {distance, 0}, Angle());
    return glm::distance(poseBetween(mesh_, {before, now, 0.25}).position, mesh_.toWorld(0, {0, 0}));
  };
  EXPECT_NEAR(drawnAt(24), 6, 1e-6);
  EXPECT_NEAR(drawnAt(40), 40, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(OnEverySolid, PoseBetweenTest, testing::Range(0, kSolidKinds));

}  // namespace
}  // namespace platon::pose_between_test
