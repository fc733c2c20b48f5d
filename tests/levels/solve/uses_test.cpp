#include "levels/solve/uses.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::uses_test {
namespace {

TEST(UsesTest, APlayerUsesThePlateOnWhichItStands) {
  PlayedGame played(
      cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n-40 -200 40 -200 plate 1\n100 -200 160 -200 plate 1"}));
  played.run(60, kNone);
  const auto& elements = played.game.level().elements;
  EXPECT_TRUE(uses(played.game, 0, elements[0]));
  EXPECT_FALSE(uses(played.game, 0, elements[1])) << "it opens the same doors, but is elsewhere";
  played.run(3, Input::kJump);
  EXPECT_FALSE(uses(played.game, 0, elements[0])) << "in the air";
  played.hold(1, kNone);
  played.run(80, kNone);
  EXPECT_TRUE(uses(played.game, 1, elements[0]));
}

}  // namespace
}  // namespace platon::uses_test
