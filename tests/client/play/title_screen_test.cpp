#include "client/play/title_screen.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/test_levels.h"

namespace platon::title_screen_test {
namespace {

TEST(TitleGame, ABallRollsOnTheLevelForEver) {
  TitleGame game;
  EXPECT_FALSE(game.shows());
  game.show(flatLevel());
  ASSERT_TRUE(game.shows());
  const Scene before = game.scene({});
  ASSERT_EQ(before.players.size(), 1U);
  EXPECT_TRUE(before.players.front().local);
  EXPECT_NE(game.game().player(0).ground, Point()) << "it does not begin with a fall";
  game.advance(0.5);
  EXPECT_NE(game.scene({}).focus.position, before.focus.position);
  for (int second = 0; second < 4 * 400; ++second) game.advance(0.25);
  EXPECT_FALSE(game.game().over()) << "longer than a round";
}

TEST(TitleGame, AnotherLevelBeginsAnewAndTheSameOneGoesOn) {
  const std::shared_ptr<const Level> first = flatLevel();
  TitleGame game;
  game.show(first);
  const std::uint32_t start = game.game().tick();
  game.advance(0.2);
  game.show(first);
  EXPECT_EQ(game.game().tick(), start + 12);
  game.show(flatLevel());
  EXPECT_EQ(game.game().tick(), start);
}

TEST(TitleGame, ALatePictureIsNotMadeUpFor) {
  TitleGame game;
  game.show(flatLevel());
  const std::uint32_t start = game.game().tick();
  game.advance(100);
  EXPECT_EQ(game.game().tick(), start + TitleGame::kMaxTicks);
}

}  // namespace
}  // namespace platon::title_screen_test
