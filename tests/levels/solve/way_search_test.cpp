#include "levels/solve/way_search.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::way_search_test {
namespace {

using Target = WaySearch::Target;

const std::string kFlat = "-240 -200 240 -200\n";

Game standing(const std::string& lines, const std::string& goal) {
  PlayedGame played(cubeLevel("0 0 -180 0", {kFlat + lines}, goal));
  played.run(30, kNone);
  return played.game;
}

// The game after the inputs to the target.
Game played(Game game, const WaySearch& search, const Target& target) {
  for (const Input input : search.inputsTo(target)) game.advance({&input, 1});
  return game;
}

TEST(WaySearchTest, FindsAWayThatReachesTheGoalInItsLastTick) {
  const Game start = standing("40 -150 140 -150\n", "0 110 -134");
  WaySearch search(start, 0);
  ASSERT_TRUE(search.find({}));
  std::vector<Input> inputs = search.inputsTo({});
  EXPECT_LT(inputs.size(), 90u);
  EXPECT_NE(played(start, search, {}).player(0).arrived, 0);
  inputs.pop_back();
  Game game = start;
  for (const Input input : inputs) game.advance({&input, 1});
  EXPECT_EQ(game.player(0).arrived, 0);
}

TEST(WaySearchTest, AnEstimateOfTheTicksThatAreLeftFindsAWaySooner) {
  const Game start = standing("40 -150 140 -150\n", "0 110 -134");
  WaySearch plain(start, 0);
  WaySearch::Limits limits;
  limits.ticksLeft = [](const Game& game) {
    const Point place = game.world().entities()[0].position;
    return static_cast<std::uint32_t>(std::abs(game.level().goal.x - place.x) / 1024);
  };
  WaySearch hasty(start, 0, limits);
  ASSERT_TRUE(plain.find({}));
  ASSERT_TRUE(hasty.find({}));
  EXPECT_LT(3 * hasty.states(), plain.states());
  EXPECT_NE(played(start, hasty, {}).player(0).arrived, 0);
}

TEST(WaySearchTest, EndsWhenThereIsNoWay) {
  const Game start = standing("-200 -200 -200 -60\n200 -200 200 -60\n-200 -60 200 -60\n", "0 0 100");
  WaySearch search(start, 0);
  EXPECT_FALSE(search.find({}));
  EXPECT_FALSE(search.work(1000000));
  EXPECT_GT(search.states(), 100u);
}

TEST(WaySearchTest, KeepsToTheLimitOfCrossings) {
  const Game start = standing("", "1 0 0");
  WaySearch::Limits limits;
  limits.crossings = 0;
  WaySearch search(start, 0, limits);
  search.findAll();
  EXPECT_TRUE(search.found().empty());
}

TEST(WaySearchTest, FindsKeysAndPlates) {
  const Game start = standing("-80 -180 -80 -160 key 2\n60 -200 120 -200 plate 5\n", "5 0 0");
  WaySearch search(start, 0);
  ASSERT_TRUE(search.find({Target::Kind::kPlate, 1}));
  ASSERT_TRUE(search.find({Target::Kind::kKey, 0}));
  EXPECT_EQ(played(start, search, {Target::Kind::kPlate, 1}).openDoors(), 1u << 5);
  EXPECT_EQ(played(start, search, {Target::Kind::kKey, 0}).openDoors() & 1u << 2, 1u << 2);
}

// In a room, the checkpoint lies across the way to the goal.
TEST(WaySearchTest, KeepsOffACheckpointThatItIsToGoWithout) {
  const Game start =
      standing("-200 -200 -200 -60\n200 -200 200 -60\n-200 -60 200 -60\n60 -200 60 -60 checkpoint\n", "0 120 -184");
  WaySearch::Limits limits;
  EXPECT_TRUE(WaySearch(start, 0, limits).find({}));
  limits.without = {{ElementKind::kCheckpoint}};
  EXPECT_FALSE(WaySearch(start, 0, limits).find({}));
}

TEST(WaySearchTest, KeepsOffWhatItIsToGoWithout) {
  const Game start = standing("-80 -180 -80 -160 key 2\n60 -200 120 -200 plate 5\n", "5 0 0");
  const std::vector<ElementWord> words = {{ElementKind::kKey, 2}, {ElementKind::kPlate, 5}};
  for (const ElementWord& word : words) {
    WaySearch::Limits limits;
    limits.without = {word};
    limits.states = 20000;
    WaySearch search(start, 0, limits);
    search.findAll();
    EXPECT_EQ(search.found().contains({Target::Kind::kKey, 0}), word != words[0]) << word.text();
    EXPECT_EQ(search.found().contains({Target::Kind::kPlate, 1}), word != words[1]) << word.text();
  }
}

TEST(WaySearchTest, FewerPressesMayCostMoreTicks) {
  const Game start =
      standing("-30 -150 -230 -150\n-200 -90 -100 -90\n40 -160 100 -160\n60 -100 150 -100\n", "0 120 -60");
  const auto presses = [&](std::uint32_t cost) {
    WaySearch::Limits limits;
    limits.pressCost = cost;
    WaySearch search(start, 0, limits);
    EXPECT_TRUE(search.find({}));
    int count = 0;
    std::uint8_t held = 0;
    const std::vector<Input> inputs = search.inputsTo({});
    for (const Input input : inputs) {
      for (const std::uint8_t button : {Input::kLeft, Input::kRight, Input::kJump})
        count += input.has(button) && (held & button) == 0;
      held = input.buttons;
    }
    return std::pair(count, inputs.size());
  };
  const auto [fastPresses, fastTicks] = presses(0);
  const auto [easyPresses, easyTicks] = presses(60);
  EXPECT_LE(easyPresses, fastPresses);
  EXPECT_GE(easyTicks, fastTicks);
}

}  // namespace
}  // namespace platon::way_search_test
