#include "tests/exactness/reference/lattice_error.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "tests/exactness/reference/terrain_judge.h"

namespace platon::reference::lattice_error_test {
namespace {

constexpr auto kResolutions = std::to_array<std::int64_t>({1 << 4, 1 << 8, 1 << 10, 1 << 12, 1 << 16});
constexpr auto kTicks = std::to_array<std::int64_t>({1, 60, 600, 3600});

class LatticeErrorTest : public testing::Test {
 protected:
  /// The scenes have level and slanted floors, hollows and gentle waves, on which nearby trajectories stay together.
  static const std::map<std::string, std::vector<LatticeError>>& errors() {
    static const auto measured = [] {
      std::map<std::string, std::vector<LatticeError>> all;
      for (const auto& [name, scene] : allScenes()) all[name] = latticeErrors(name, scene, kResolutions, kTicks);
      return all;
    }();
    return measured;
  }
  static double unitsAt(const std::vector<LatticeError>& rows, std::int64_t resolution) {
    for (const LatticeError& row : rows) {
      if (row.subunitsPerUnit == resolution && row.ticks == kTicks.back()) return row.units();
    }
    ADD_FAILURE() << "no measurement at " << resolution;
    return 0;
  }
};

TEST_F(LatticeErrorTest, EverySceneIsMeasured) {
  for (const char* name : {"bowl", "ceiling", "channel", "downhill", "floor", "uphill", "waves"}) {
    EXPECT_TRUE(errors().contains(name)) << name;
  }
}

/// I8.
TEST_F(LatticeErrorTest, NeverExceedsTwoSubunits) {
  for (const auto& [name, rows] : errors()) {
    ASSERT_EQ(rows.size(), kResolutions.size() * kTicks.size());
    for (const LatticeError& row : rows) {
      EXPECT_LE(row.maxSubunits, 2) << name << " at " << row.subunitsPerUnit << " after " << row.ticks;
    }
  }
}

TEST_F(LatticeErrorTest, TicksHaveAtMostThreeLegs) {
  for (const auto& [name, rows] : errors()) {
    for (const LatticeError& row : rows) {
      EXPECT_LE(row.legs, 3 * row.ticks) << name << " at " << row.subunitsPerUnit;
    }
  }
}

TEST_F(LatticeErrorTest, TheFirstTickHasAContactInEveryScene) {
  for (const auto& [name, rows] : errors()) {
    for (const LatticeError& row : rows) {
      if (row.ticks != 1) continue;
      EXPECT_EQ(row.legs, 2) << name << " at " << row.subunitsPerUnit;
    }
  }
}

/// At a resolution 4096 times as fine the error is 4096 times as small, up to a factor of 16.
TEST_F(LatticeErrorTest, ShrinksInProportionToTheResolution) {
  for (const auto& [name, rows] : errors()) {
    const double coarse = unitsAt(rows, kResolutions.front());
    const double fine = unitsAt(rows, kResolutions.back());
    EXPECT_LE(fine * 4096 / 16, coarse) << name;
  }
}

TEST_F(LatticeErrorTest, IsZeroWithoutRounding) {
  for (const LatticeError& row : errors().at("floor")) EXPECT_EQ(row.maxSubunits, 0) << row.subunitsPerUnit;
}

/// I8 for ten minutes of play.
TEST(SlowSceneTest, NeverExceedsTwoSubunits) {
  for (const auto& [name, scene] : allSlowScenes()) {
    const Verdict verdict = judge(scene, 36000);
    EXPECT_TRUE(verdict.counts()) << name;
    EXPECT_EQ(verdict.judgedTicks, 36000) << name;
    EXPECT_LE(verdict.maxLattice, kMaxLatticeError) << name;
    EXPECT_LE(verdict.maxPrecise, kMaxPreciseError) << name;
  }
}

}  // namespace
}  // namespace platon::reference::lattice_error_test
