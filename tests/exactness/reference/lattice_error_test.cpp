#include "tests/exactness/reference/lattice_error.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace platon::reference {
namespace {

constexpr auto kResolutions = std::to_array<std::int64_t>({1 << 4, 1 << 8, 1 << 10, 1 << 12, 1 << 16});
constexpr auto kTicks = std::to_array<std::int64_t>({1, 60, 600, 3600});

/// A leg cuts its displacement to whole subunits and rounds to the outer side: less than a subunit along each axis,
/// another one or two outwards, of which the next leg takes back what is too much.
constexpr double kSubunitsPerLeg = 2;

class LatticeErrorTest : public testing::Test {
 protected:
  /// None of these scenes lets trajectories part that were close: level and slanted ground, hollows and gentle waves.
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
    ADD_FAILURE() << "nothing measured at " << resolution;
    return 0;
  }
};

TEST_F(LatticeErrorTest, ThereAreScenesOfEveryKind) {
  for (const char* name : {"bowl", "ceiling", "channel", "downhill", "floor", "uphill", "waves"}) {
    EXPECT_TRUE(errors().contains(name)) << name;
  }
}

TEST_F(LatticeErrorTest, NeverExceedsTwoSubunitsPerLeg) {
  for (const auto& [name, rows] : errors()) {
    ASSERT_EQ(rows.size(), kResolutions.size() * kTicks.size());
    for (const LatticeError& row : rows) {
      EXPECT_LE(row.mostSubunits, kSubunitsPerLeg * static_cast<double>(row.legs))
          << name << " at " << row.subunitsPerUnit << " after " << row.ticks;
    }
  }
}

/// With the law above: the error grows no faster than linearly in time.
TEST_F(LatticeErrorTest, LegsAreFew) {
  for (const auto& [name, rows] : errors()) {
    for (const LatticeError& row : rows) {
      EXPECT_LE(row.legs, 3 * row.ticks) << name << " at " << row.subunitsPerUnit;
    }
  }
}

TEST_F(LatticeErrorTest, TheFirstTickTouchesTheGroundInEveryScene) {
  for (const auto& [name, rows] : errors()) {
    for (const LatticeError& row : rows) {
      if (row.ticks != 1) continue;
      EXPECT_EQ(row.legs, 2) << name << " at " << row.subunitsPerUnit;
    }
  }
}

/// 4096 times as fine is 4096 times as good, give or take a factor of 16 by which roundings happen to cancel.
TEST_F(LatticeErrorTest, ShrinksInProportionToTheResolution) {
  for (const auto& [name, rows] : errors()) {
    const double coarse = unitsAt(rows, kResolutions.front());
    const double fine = unitsAt(rows, kResolutions.back());
    EXPECT_LE(fine * 4096 / 16, coarse) << name;
  }
}

/// Where two slopes hold it, wherever it came from. In the coarsest lattice it stops before that, when the slide of a
/// tick is less than a subunit.
TEST_F(LatticeErrorTest, IsForgottenWhereTheMoverComesToRest) {
  constexpr double restSubunits = 12;
  for (const LatticeError& row : errors().at("bowl")) {
    if (row.ticks != kTicks.back() || row.subunitsPerUnit == kResolutions.front()) continue;
    EXPECT_LE(row.subunits, restSubunits) << row.subunitsPerUnit;
    EXPECT_GT(row.mostSubunits, restSubunits) << "the way there was too short, at " << row.subunitsPerUnit;
  }
}

TEST_F(LatticeErrorTest, IsNothingWhereNothingIsRounded) {
  for (const LatticeError& row : errors().at("floor")) EXPECT_EQ(row.mostSubunits, 0) << row.subunitsPerUnit;
}

}  // namespace
}  // namespace platon::reference
