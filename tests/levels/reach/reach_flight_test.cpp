#include "levels/reach/reach_flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "tests/shared/game/played_game.h"

namespace platon::reach_flight_test {
namespace {

class ReachFlightTest : public testing::Test {
 protected:
  // Fewest crossings of the visited cells, by node and cell.
  using Visits = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

  void build(std::vector<std::string> lines) {
    level_ = cubeLevel("0 -200 200 0", std::move(lines));
    faces_.emplace(*level_);
    for (std::uint32_t node = 0; node < faces_->all().size(); ++node)
      grids_.push_back(std::make_unique<ReachGrid>(*level_, *faces_, node, 2.0));
  }
  // A flight from one place on the first face. Calls visitor(ReachVisit).
  template <class Visitor>
  void fly(Vec from, bool rising, double speed, double apex, int maxCrossings, Visitor&& visitor) {
    std::vector<std::vector<ReachKnown>> known;
    for (const auto& grid : grids_) known.emplace_back(2 * grid->size());
    const ReachFlight::World world{*faces_, grids_, ~0U, known, maxCrossings};
    const auto cell = static_cast<std::uint32_t>(grids_[0]->cellAt(from));
    ReachFlight(world, {0, rising, false, speed, apex, {cell}}, 0).run(visitor);
  }
  Visits fly(Vec from, bool rising, double apex, int maxCrossings = 0) {
    Visits visits;
    fly(from, rising, run_, apex, maxCrossings,
        [&](const ReachVisit& visit) { visits.emplace(std::pair(visit.node, visit.cell), visit.crossings); });
    return visits;
  }
  // The largest speed at a place, of a flight from (0, 0) on the first face; 0 if it does not get there.
  double speedAt(Vec place, bool rising, double speed) {
    const std::size_t cell = grids_[0]->cellAt(place);
    double most = 0;
    fly({0, 0}, rising, speed, rising ? 60 : 1, 0, [&](const ReachVisit& visit) {
      if (visit.node == 0 && visit.cell == cell) most = std::max(most, visit.speed);
    });
    return most;
  }
  bool contains(const Visits& visits, Vec place) const {
    return visits.contains({0, static_cast<std::uint32_t>(grids_[0]->cellAt(place))});
  }

  const double run_ = FlightEnvelope::measured().runSpeed();
  const double slide_ = FlightEnvelope::measured().slideSpeed();

  std::shared_ptr<const Level> level_;
  std::optional<UprightFaces> faces_;
  std::vector<std::unique_ptr<ReachGrid>> grids_;
};

TEST_F(ReachFlightTest, AFallNeverRises) {
  build({""});
  const Visits visits = fly({0, 0}, false, 1);
  EXPECT_TRUE(contains(visits, {0, -200}));
  EXPECT_FALSE(contains(visits, {0, 5}));
}

TEST_F(ReachFlightTest, AJumpRisesToItsApexAndMovesSidewaysInItsTime) {
  build({""});
  const Visits visits = fly({0, 0}, true, 60);
  EXPECT_TRUE(contains(visits, {0, 59}));
  EXPECT_FALSE(contains(visits, {0, 63}));
  EXPECT_TRUE(contains(visits, {100, 59}));
  EXPECT_FALSE(contains(visits, {145, 59})) << "44 ticks at 3.2 units";
  EXPECT_TRUE(contains(visits, {170, 1}));
  EXPECT_FALSE(contains(visits, {225, 1}));
}

TEST_F(ReachFlightTest, WallsAreGoneRoundNotThrough) {
  build({"-50 30 50 30\n-50 30 -50 -240\n50 30 50 -240"});
  const Visits visits = fly({0, 0}, true, 60);
  EXPECT_TRUE(contains(visits, {0, 18}));
  EXPECT_FALSE(contains(visits, {0, 45})) << "behind the ceiling";
  EXPECT_FALSE(contains(visits, {70, 0})) << "behind the wall";
}

TEST_F(ReachFlightTest, AOnewaySegmentIsPassedFromItsRightOnly) {
  build({"-240 30 240 30 oneway\n-240 -40 240 -40 oneway"});
  const Visits visits = fly({0, 0}, true, 60);
  EXPECT_TRUE(contains(visits, {0, 55})) << "upwards";
  EXPECT_TRUE(contains(visits, {0, -27}));
  EXPECT_FALSE(contains(visits, {0, -60})) << "downwards";
}

TEST_F(ReachFlightTest, ASlideIsSlowerFartherAway) {
  build({""});
  EXPECT_DOUBLE_EQ(speedAt({0, -20}, false, slide_), slide_);
  EXPECT_LT(speedAt({100, -200}, false, slide_), slide_ - 0.5);
  EXPECT_GT(speedAt({100, -200}, false, slide_), slide_ - 1);
  EXPECT_DOUBLE_EQ(speedAt({30, -200}, false, run_), run_);
}

TEST_F(ReachFlightTest, CountsTheEdgesThatItCrosses) {
  build({""});
  const Visits visits = fly({0, -200}, false, -199, 2);
  std::map<int, std::set<std::uint32_t>> faces;
  for (const auto& [place, crossings] : visits) faces[crossings].insert(faces_->all()[place.first].face);
  EXPECT_EQ(faces[0], (std::set<std::uint32_t>{0}));
  EXPECT_TRUE(faces[1].contains(5)) << "below the first face";
  EXPECT_TRUE(faces[2].contains(2)) << "below that one";
  EXPECT_EQ(faces.size(), 3u);
}

}  // namespace
}  // namespace platon::reach_flight_test
