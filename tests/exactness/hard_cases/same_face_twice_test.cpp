// Round every corner of a tetrahedron there are but 180 degrees: a ball beside it reaches one face from both sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/shared/game/real_face.h"

namespace platon::hard_cases {
namespace {

const std::string kLevel = "same_face_twice/tetrahedron.level";
const RealFace kIdeal(SolidKind::kTetrahedron, 480);
constexpr double kBeside = 12.3 * kSubunitsPerUnit;  // of the ball's middle from the corner

/// The parts that more than one instance is in.
std::vector<std::uint32_t> partsSeenTwice(const HardLevel& level) {
  std::set<std::uint32_t> seen;
  std::vector<std::uint32_t> twice;
  for (const InstanceView& view : level.world.view(0)) {
    if (!seen.insert(view.part).second) twice.push_back(view.part);
  }
  return twice;
}

/// Beside a corner, so many degrees counter-clockwise of the line from the corner to the face's middle.
Real beside(int corner, int degrees, double distance = kBeside) {
  const Real inwards = (-1 / length(kIdeal.corner(corner))) * kIdeal.corner(corner);
  return kIdeal.corner(corner) + distance * turned(inwards, Angle::degrees(degrees));
}

int nearestCorner(Point at) {
  const auto distance = [&](int corner) { return length(kIdeal.corner(corner) - real(at)); };
  return std::min({0, 1, 2}, [&](int a, int b) { return distance(a) < distance(b); });
}

// The ball, with its 16 corners, is seen from the corner under 2 * 73 to 2 * 77 degrees, its face under 60. More than
// 17 degrees aside, it reaches past the neighbour on that side, by 90 degrees, into the other neighbour, which it
// reaches on the other side as well; less than 13 aside it does not.
TEST(SameFaceTwiceTest, AsideItReachesOneNeighbourTwice) {
  HardLevel level(kLevel);
  for (int face = 0; face < 4; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      for (const int degrees : {-29, -25, -20, -9, -4, 0, 4, 9, 20, 25, 29}) {
        SCOPED_TRACE("face " + std::to_string(face) + ", corner " + std::to_string(corner) + ", " +
                     std::to_string(degrees) + " degrees aside");
        ASSERT_TRUE(level.place(static_cast<std::uint32_t>(face), nearest(beside(corner, degrees))));
        level.push({});
        const bool aside = degrees * degrees > 17 * 17;
        EXPECT_EQ(level.checker.instances(0), aside ? 4u : 3u);
        // Clockwise round the corner comes the edge that begins there.
        const int edge = degrees > 0 ? corner : (corner + 2) % 3;
        const std::uint32_t other = PlatonicSolid::of(SolidKind::kTetrahedron).neighbour(face, edge).face;
        EXPECT_EQ(partsSeenTwice(level), aside ? std::vector{other} : std::vector<std::uint32_t>{});
      }
    }
  }
}

/// One tick round the nearest corner of home, a degree or so, and towards it.
void walkRound(HardLevel& level, int way) {
  const Real corner = kIdeal.corner(nearestCorner(level.at()));
  const Real outwards = real(level.at()) - corner;
  const Real along = (way * 220 / length(outwards)) * left(outwards);
  level.tick(nearest(along + (20 / length(outwards)) * (corner - real(level.at()))));
}

TEST(SameFaceTwiceTest, RoundACornerAndOutAgain) {
  for (int face = 0; face < 4; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      for (const int way : {1, -1}) {
        SCOPED_TRACE("face " + std::to_string(face) + ", corner " + std::to_string(corner) + ", way " +
                     std::to_string(way));
        HardLevel level(kLevel);
        ASSERT_TRUE(level.place(static_cast<std::uint32_t>(face), nearest(beside(corner, 0))));
        int twice = 0;
        int ticks = 0;
        for (; level.entity().state().crossings < 6 && ticks < 1500; ++ticks) {
          walkRound(level, way);
          twice += !partsSeenTwice(level).empty();
        }
        // Six faces further are two tours of half a turn each.
        EXPECT_EQ(level.entity().state().crossings, 6u);
        EXPECT_EQ(level.entity().part(), static_cast<std::uint32_t>(face));
        EXPECT_EQ(level.entity().rotation(), Angle());
        EXPECT_GT(twice, ticks / 3) << "for 34 degrees of every 60";
        const Real toMiddle = (-3000 / length(real(level.at()))) * real(level.at());
        for (int tick = 0; tick < 40; ++tick) level.tick(nearest(toMiddle));
        EXPECT_EQ(level.world.view(0).size(), 1u) << "out again";
        EXPECT_TRUE(level.lawful());
      }
    }
  }
}

// Straight towards the corner and back: instances come and go, and home, which crosses nothing, is where it was.
TEST(SameFaceTwiceTest, InAndStraightBack) {
  HardLevel level(kLevel);
  for (int face = 0; face < 4; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      for (const int degrees : {-28, -21, 19, 25}) {
        SCOPED_TRACE("face " + std::to_string(face) + ", corner " + std::to_string(corner) + ", " +
                     std::to_string(degrees) + " degrees aside");
        const Real from = beside(corner, degrees, 60 * kSubunitsPerUnit);
        ASSERT_TRUE(level.place(static_cast<std::uint32_t>(face), nearest(from)));
        const Point start = level.at();
        const Point step = nearest((1.0 / 30) * (beside(corner, degrees) - from));
        EXPECT_LE(level.world.view(0).size(), 2u);
        for (int tick = 0; tick < 60; ++tick) {
          level.push(tick < 30 ? step : -step);
          EXPECT_TRUE(level.rules.contacts.empty());
          if (tick == 29) {
            EXPECT_EQ(partsSeenTwice(level).size(), 1u);
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
}  // namespace platon::hard_cases
