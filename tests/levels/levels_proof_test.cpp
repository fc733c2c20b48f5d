// That each shipped level needs the crossings that it states, and that the proof would find a shortcut.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "levels/reach/jump_heights.h"
#include "levels/reach/reach.h"
#include "levels/solve/level_solver.h"
#include "platon/game/game.h"
#include "tests/levels/shipped_level.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"

namespace platon::levels_proof_test {
namespace {

// One level of each solid whose shortcut has crossings.
const std::vector<std::string> kOneOfEachSolid{
    "levels/data/hexahedron/05_key_on_the_wall.level", "levels/data/tetrahedron/10_two_ups.level",
    "levels/data/octahedron/16_the_long_key.level", "levels/data/dodecahedron/22_one_turn_is_not_enough.level",
    "levels/data/icosahedron/30_four_downs.level"};

std::shared_ptr<const Level> withGoal(const Level& level, const EntityState& place) {
  char goal[80];
  std::snprintf(goal, sizeof goal, "%u %.4f %.4f", place.part, place.position.x / 1024.0, place.position.y / 1024.0);
  return changed(level, [&](int number, const std::string& line) { return number == level.goalAt.line ? goal : line; });
}

std::shared_ptr<const Level> forOnePlayer(const Level& level) {
  return changed(level, [](int, const std::string& line) { return line.starts_with("# players:") ? "#" : line; });
}

class LevelProofTest : public testing::TestWithParam<std::string> {
 protected:
  LevelProofTest() : shipped_(GetParam()), level_(shipped_.level()) {}

  int crossings() const { return static_cast<int>(level_->crossings.value_or(0)); }

  // Plays the recorded way, and calls visit(player) for each player that has fewer crossings than the level states.
  template <class Visitor>
  void forEachEarlyPlace(Visitor&& visit) {
    Game game(level_);
    for (const std::vector<Input>& inputs : shipped_.way()) {
      game.advance(inputs);
      for (const EntityState& player : game.world().entities()) {
        if (static_cast<int>(player.crossings) < crossings()) visit(player);
      }
    }
  }

  ShippedLevel shipped_;
  std::shared_ptr<const Level> level_;
};

// The bound must also allow what players really do: wherever one is on the recorded way, with as many crossings.
TEST_P(LevelProofTest, EveryWayNeedsTheCrossingsThatTheLevelStates) {
  const auto& brief = kOneOfEachSolid;
  if (isBrief() && std::find(brief.begin(), brief.end(), GetParam()) == brief.end()) GTEST_SKIP() << "a brief run";
  if (crossings() == 0) return;
  const Reach reach(*level_, crossings() - 1);
  EXPECT_EQ(reach.crossingsToGoal(), std::nullopt)
      << "see platon-level solve --without-crossing " << crossings() << " " << GetParam();
  forEachEarlyPlace([&](const EntityState& player) {
    const auto least = reach.crossingsTo(player.part, player.position, player.angle);
    EXPECT_TRUE(least && *least <= static_cast<int>(player.crossings))
        << "face " << player.part << " at " << player.position.x / 1024 << " " << player.position.y / 1024;
  });
}

TEST_P(LevelProofTest, EveryWayUsesWhatTheLevelStatesThatItNeeds) {
  for (const ElementWord need : level_->needs) {
    EXPECT_FALSE(JumpHeights(*level_, {.without = {need}}).reachesGoal())
        << "see platon-level solve --without " << need.text() << " " << GetParam();
  }
}

// So that a need that is stated by mistake would be found: it is not proved of what may be gone without.
TEST_P(LevelProofTest, ANeedIsNotProvedWhenItsDoorsAreOpen) {
  for (const ElementWord need : level_->needs) {
    const auto open = changed(*level_, [&](int, const std::string& line) {
      return line.ends_with(" door " + std::to_string(need.number)) ? "" : line;
    });
    ASSERT_TRUE(open);
    EXPECT_TRUE(JumpHeights(*open, {.without = {need}}).reachesGoal()) << need.text();
  }
}

class PlantedShortcutTest : public LevelProofTest {};

// The goal is moved to the last place on the recorded way that has fewer crossings than the level states.
TEST_P(PlantedShortcutTest, IsFound) {
  if (crossings() == 0) return;
  std::optional<EntityState> place;
  forEachEarlyPlace([&](const EntityState& player) { place = player; });
  ASSERT_TRUE(place);
  const auto planted = withGoal(*level_, *place);
  ASSERT_TRUE(planted);
  const auto found = Reach(*planted, crossings() - 1).crossingsToGoal();
  ASSERT_TRUE(found) << "a way with " << place->crossings << " crossings is not found";
  EXPECT_LE(*found, static_cast<int>(place->crossings));
}

// A search, not a proof: all ways that differ by more than a few subunits.
TEST_P(LevelProofTest, NobodyFindsAWayAloneThroughALevelForTwo) {
  if (level_->players < 2) return;
  const auto alone = forOnePlayer(*level_);
  ASSERT_TRUE(alone);
  LevelSolver solver(alone);
  EXPECT_FALSE(solver.solve());
  EXPECT_LT(solver.states(), LevelSolver::Limits().states) << "not everything was searched";
}

INSTANTIATE_TEST_SUITE_P(All, LevelProofTest, testing::ValuesIn(shippedLevels()),
                         [](const auto& spec) { return shippedName(spec.param); });

INSTANTIATE_TEST_SUITE_P(OneOfEachSolid, PlantedShortcutTest, testing::ValuesIn(kOneOfEachSolid),
                         [](const auto& spec) { return shippedName(spec.param); });

}  // namespace
}  // namespace platon::levels_proof_test
