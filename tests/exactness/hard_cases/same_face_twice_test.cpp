// The angles around a corner of a tetrahedron sum to 180 degrees, so a ball beside it reaches one face from two sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/shared/game/real_face.h"

namespace platon::hard_cases::same_face_twice_test {
namespace {

const std::string kLevel = "same_face_twice/tetrahedron.level";
const RealFace kIdeal(SolidKind::kTetrahedron, 480);
constexpr double kBeside = 12.3 * kSubunitsPerUnit;  // distance of the ball's centre from the corner

/// The map parts in which the ball has more than one instance.
std::vector<std::uint32_t> partsWithTwoInstances(const HardLevel& level) {
  std::set<std::uint32_t> seen;
  std::vector<std::uint32_t> twice;
  for (const InstanceView& view : level.world.view(0)) {
    if (!seen.insert(view.part).second) twice.push_back(view.part);
  }
  return twice;
}

/// A point at `distance` from a corner, `degrees` counter-clockwise of the direction from the corner to the face's
/// centre.
Real beside(int corner, int degrees, double distance = kBeside) {
  const Real inwards = (-1 / length(kIdeal.corner(corner))) * kIdeal.corner(corner);
  return kIdeal.corner(corner) + distance * turned(inwards, Angle::degrees(degrees));
}

int nearestCorner(Point at) {
  const auto distance = [&](int corner) { return length(kIdeal.corner(corner) - real(at)); };
  return std::min({0, 1, 2}, [&](int a, int b) { return distance(a) < distance(b); });
}

// Seen from the corner, the 16-gon spans 2 * 73 to 2 * 77 degrees and its face 60. If its centre is more than 17
// degrees off the middle, it reaches beyond the neighbour on that side, by 90 degrees, into the other neighbour, which
// it also reaches from the other side. Below 13 degrees it does not.
TEST(SameFaceTwiceTest, ReachesOneNeighbourTwiceOffTheMiddle) {
  HardLevel level(kLevel);
  for (int face = 0; face < 4; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      for (const int degrees : {-29, -25, -20, -9, -4, 0, 4, 9, 20, 25, 29}) {
        SCOPED_TRACE("face " + std::to_string(face) + ", corner " + std::to_string(corner) + ", " +
                     std::to_string(degrees) + " degrees off the middle");
        ASSERT_TRUE(level.place(static_cast<std::uint32_t>(face), nearest(beside(corner, degrees))));
        level.push({});
        const bool isOffTheMiddle = degrees * degrees > 17 * 17;
        EXPECT_EQ(level.checker.instances(0), isOffTheMiddle ? 4u : 3u);
        // The next edge clockwise around the corner is the one that begins there.
        const int edge = degrees > 0 ? corner : (corner + 2) % 3;
        const std::uint32_t other = PlatonicSolid::of(SolidKind::kTetrahedron).neighbour(face, edge).face;
        EXPECT_EQ(partsWithTwoInstances(level), isOffTheMiddle ? std::vector{other} : std::vector<std::uint32_t>{});
      }
    }
  }
}

/// Moves the ball for one tick by about one degree around the nearest corner of the home face, and slightly towards it.
void moveAroundCorner(HardLevel& level, int direction) {
  const Real corner = kIdeal.corner(nearestCorner(level.at()));
  const Real outwards = real(level.at()) - corner;
  const Real along = (direction * 220 / length(outwards)) * left(outwards);
  level.tick(nearest(along + (20 / length(outwards)) * (corner - real(level.at()))));
}

TEST(SameFaceTwiceTest, MovesTwiceAroundACornerAndAway) {
  for (int face = 0; face < 4; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      for (const int direction : {1, -1}) {
        SCOPED_TRACE("face " + std::to_string(face) + ", corner " + std::to_string(corner) + ", direction " +
                     std::to_string(direction));
        HardLevel level(kLevel);
        ASSERT_TRUE(level.place(static_cast<std::uint32_t>(face), nearest(beside(corner, 0))));
        int twice = 0;
        int ticks = 0;
        for (; level.entity().state().crossings < 6 && ticks < 1500; ++ticks) {
          moveAroundCorner(level, direction);
          twice += !partsWithTwoInstances(level).empty();
        }
        // Six crossings are two turns around the corner, whose angles sum to 180 degrees.
        EXPECT_EQ(level.entity().state().crossings, 6u);
        EXPECT_EQ(level.entity().part(), static_cast<std::uint32_t>(face));
        EXPECT_EQ(level.entity().rotation(), Angle());
        EXPECT_GT(twice, ticks / 3) << "two instances on one face expected in 34 of every 60 degrees";
        const Real toMiddle = (-3000 / length(real(level.at()))) * real(level.at());
        for (int tick = 0; tick < 40; ++tick) level.tick(nearest(toMiddle));
        EXPECT_EQ(level.world.view(0).size(), 1u) << "only one instance expected away from the corner";
        EXPECT_TRUE(level.invariantsHold());
      }
    }
  }
}

// Straight towards the corner and back: instances are added and dropped, and the home instance, which crosses no edge,
// returns exactly.
TEST(SameFaceTwiceTest, MovesTowardsACornerAndBack) {
  HardLevel level(kLevel);
  for (int face = 0; face < 4; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      for (const int degrees : {-28, -21, 19, 25}) {
        SCOPED_TRACE("face " + std::to_string(face) + ", corner " + std::to_string(corner) + ", " +
                     std::to_string(degrees) + " degrees off the middle");
        const Real from = beside(corner, degrees, 60 * kSubunitsPerUnit);
        ASSERT_TRUE(level.place(static_cast<std::uint32_t>(face), nearest(from)));
        const Point start = level.at();
        const Point step = nearest((1.0 / 30) * (beside(corner, degrees) - from));
        EXPECT_LE(level.world.view(0).size(), 2u);
        for (int tick = 0; tick < 60; ++tick) {
          level.push(tick < 30 ? step : -step);
          EXPECT_TRUE(level.rules.contacts.empty());
          if (tick == 29) {
            EXPECT_EQ(partsWithTwoInstances(level).size(), 1u);
          }
        }
        EXPECT_EQ(level.at(), start);
        EXPECT_LE(level.world.view(0).size(), 2u);
        EXPECT_EQ(level.entity().state().crossings, 0u);
      }
    }
  }
}

}  // namespace
}  // namespace platon::hard_cases::same_face_twice_test
