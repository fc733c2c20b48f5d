#include "levels/reach/reach_grid.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::reach_grid_test {
namespace {

constexpr double kCell = 2;

class ReachGridTest : public testing::Test {
 protected:
  // The first face of a cube with these lines.
  const ReachGrid& gridOf(const std::string& lines, const std::string& goal = "5 0 0") {
    level_ = cubeLevel("0 -200 200 0", {lines}, goal);
    faces_.emplace(*level_);
    grid_.emplace(*level_, *faces_, 0, kCell);
    return *grid_;
  }
  const ReachGrid::Cell& at(double x, double y) const { return (*grid_)[grid_->cellAt({x, y})]; }

 private:
  std::shared_ptr<const Level> level_;
  std::optional<UprightFaces> faces_;
  std::optional<ReachGrid> grid_;
};

TEST_F(ReachGridTest, ACellHasItsRectangle) {
  const ReachGrid& grid = gridOf("");
  for (std::size_t cell = 0; cell < grid.size(); cell += 97) EXPECT_EQ(grid.cellAt(grid.rectOf(cell).middle()), cell);
  EXPECT_EQ(grid.cellAt({300, 0}), grid.size());
  EXPECT_TRUE(at(239, 239).inside);
}

TEST_F(ReachGridTest, CellsAreBlockedOnlyWhereNoPlayerFits) {
  gridOf("-100 0 100 0");
  EXPECT_TRUE(at(0, 5).blocked);
  EXPECT_TRUE(at(0, -8).blocked);
  EXPECT_FALSE(at(0, 11.9).blocked) << "a player stands here";
  EXPECT_FALSE(at(113, 0).blocked) << "beside its end";
}

TEST_F(ReachGridTest, APlayerStandsOnFloorsAndEndsOnly) {
  gridOf("-100 0 100 0\n150 -100 150 100\n-150 -100 -220 100");
  EXPECT_TRUE(at(0, 11.8).grounded);
  EXPECT_FALSE(at(0, 11.8).sloped);
  EXPECT_NEAR(at(0, 11.8).highest, 12, 0.1);
  EXPECT_FALSE(at(0, 30).grounded);
  EXPECT_FALSE(at(0, -11.8).grounded) << "below a ceiling";
  EXPECT_FALSE(at(138, 0).grounded) << "beside a wall";
  EXPECT_TRUE(at(150, 112).grounded) << "on the end of a wall";
  EXPECT_TRUE(at(150, 112).sloped);
  EXPECT_FALSE(at(-173, 0).grounded) << "on a steep segment";
  EXPECT_TRUE(at(-173, 0).steep);
}

TEST_F(ReachGridTest, APlayerStandsInAWedge) {
  gridOf("-12 -100 -12 100\n8 -100 30 100\n100 -100 100 100\n124 -100 124 100");
  EXPECT_TRUE(at(0, -63).grounded);
  EXPECT_TRUE(at(0, -63).sloped);
  EXPECT_FALSE(at(0, 60).grounded) << "too wide to touch both sides in one tick";
  EXPECT_FALSE(at(112, 0).grounded) << "no side pushes up";
}

TEST_F(ReachGridTest, APlayerStandsOnThePostAtACorner) {
  gridOf("");
  EXPECT_TRUE(at(-235, -229).grounded);
}

TEST_F(ReachGridTest, HazardsCarryNobodyAndDoorsBlockByTheirNumber) {
  gridOf("-100 0 100 0 hazard\n-100 100 100 100 door 5");
  EXPECT_TRUE(at(0, 0).blocked);
  EXPECT_FALSE(at(0, 11.8).grounded);
  EXPECT_FALSE(at(0, 100).blocked);
  EXPECT_EQ(at(0, 100).doors, 32u);
}

TEST_F(ReachGridTest, TheGoalIsTouchedWithin28Units) {
  gridOf("", "0 50 50");
  EXPECT_TRUE(at(50, 77).atGoal);
  EXPECT_FALSE(at(50, 81).atGoal);
}

TEST_F(ReachGridTest, TriggersAreTouched) {
  const ReachGrid& grid = gridOf("0 0 0 40 key 7\n-100 -100 0 -100 plate 7");
  ASSERT_EQ(grid.touched(grid.cellAt({9, 20})).size(), 1u);
  EXPECT_EQ(grid.touched(grid.cellAt({9, 20}))[0].element->kind, ElementKind::kKey);
  EXPECT_TRUE(grid.touched(grid.cellAt({30, 20})).empty());
  EXPECT_EQ(grid.touched(grid.cellAt({-50, -88})).size(), 1u);
}

}  // namespace
}  // namespace platon::reach_grid_test
