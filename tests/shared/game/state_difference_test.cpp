#include "platon/game/state_difference.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/shared/game/played_game.h"
#include "tests/sim/churn.h"

namespace platon::state_difference_test {
namespace {

std::shared_ptr<const Level> level() {
  static const auto loaded = cubeLevel("0 0 -180 0", {"-240 -200 240 -200"});
  return loaded;
}

TEST(StateDifferenceTest, EqualGamesDoNotDiffer) {
  Game game(level());
  sim::Churn churn(3, 4);
  for (int tick = 0; tick < 300; ++tick) {
    game.advance(churn.next());
    const Game copy = game;
    ASSERT_FALSE(firstDifference(game, copy));
  }
}

TEST(StateDifferenceTest, ListsEveryFieldOnce) {
  PlayedGame played(level());
  played.hold(1, Input::kRight);
  played.run(200, Input::kRight);
  std::set<std::pair<std::string, std::string>> names;
  for (const StateField& field : fieldsOf(played.game)) {
    EXPECT_TRUE(names.emplace(field.owner, field.name).second) << field.owner << " " << field.name;
  }
  EXPECT_TRUE(names.contains({"entity 1", "position"}));
  EXPECT_TRUE(names.contains({"player 0", "held"}));
}

TEST(StateDifferenceTest, NamesTheFieldAndBothValues) {
  PlayedGame still(level());
  PlayedGame moving(level());
  still.run(1, kNone);
  moving.run(1, Input::kDown);
  const auto found = firstDifference(still.game, moving.game);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->owner, "player 0");
  EXPECT_EQ(found->field, "startedAt");
  EXPECT_EQ(found->left, "0");
  EXPECT_EQ(found->right, "1");
}

// Every bit of the saved state belongs to a field.
TEST(StateDifferenceTest, FindsEveryChangedBit) {
  PlayedGame played(level());
  played.hold(1, Input::kRight);
  played.run(100, Input::kLeft);
  auto bytes = played.game.save();
  int valid = 0;
  std::set<std::string> fields;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    Game other(level());
    if (other.restore(bytes)) {
      ++valid;
      const auto found = firstDifference(played.game, other);
      ASSERT_TRUE(found) << "bit " << bit;
      ASSERT_NE(found->left, found->right);
      ASSERT_NE(played.game.hash(), other.hash()) << "bit " << bit;
      fields.insert(found->field);
    }
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
  }
  EXPECT_GT(valid, 500);
  EXPECT_GE(fields.size(), 15u);
}

TEST(StateDifferenceTest, FindsAPlayerThatOnlyOneGameHas) {
  PlayedGame one(level());
  PlayedGame two(level());
  one.run(1, kNone);
  two.hold(1, kNone);
  two.run(1, kNone);
  const auto found = firstDifference(one.game, two.game);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->owner, "game");
  EXPECT_EQ(found->field, "slots");
}

}  // namespace
}  // namespace platon::state_difference_test
