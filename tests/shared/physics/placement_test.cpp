#include "shared/physics/placement.h"

#include <gtest/gtest.h>

#include "tests/sim/seeded_random.h"

namespace platon::placement_test {
namespace {

constexpr std::uint64_t kSeed = 55;

Placement turnedBy(Angle angle) {
  Placement placement;
  placement.fromHome = rotationOf(angle);
  placement.toHome = rotationOf(-angle);
  placement.homeAnchor = {100, 200};
  placement.anchor = {-5000, 70};
  return placement;
}

TEST(PlacementTest, IsAtTheAnchorWhenHomeIsAtItsAnchor) {
  for (const std::int32_t angle : {0, 3600, 9000, 12345}) {
    EXPECT_EQ(turnedBy(Angle(angle)).at({100, 200}), Point(-5000, 70));
  }
}

TEST(PlacementTest, MovesWithHomeInItsOwnFrame) {
  EXPECT_EQ(turnedBy(Angle()).at({107, 197}), Point(-4993, 67));
  EXPECT_EQ(turnedBy(Angle::degrees(90)).at({107, 197}), Point(-4997, 77));
  EXPECT_EQ(turnedBy(Angle::degrees(180)).at({107, 197}), Point(-5007, 73));
}

TEST(PlacementTest, RoundsTheWholeMoveOnce) {
  sim::SeededRandom random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const Angle angle(static_cast<std::int32_t>(random.below(Angle::kTurn)));
    const Placement placement = turnedBy(angle);
    const Point home = random.vector(1 << 20);
    ASSERT_EQ(placement.at(home), placement.anchor + rotate(home - placement.homeAnchor, angle))
        << "seed " << kSeed << ", round " << i;
  }
}

}  // namespace
}  // namespace platon::placement_test
