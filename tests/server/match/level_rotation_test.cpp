#include "server/match/level_rotation.h"

#include <gtest/gtest.h>

#include "tests/support/test_levels.h"

namespace platon::level_rotation_test {
namespace {

TEST(LevelRotation, StartsOverAfterTheLastLevel) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far, near});
  for (int lap = 0; lap < 2; ++lap) {
    EXPECT_EQ(rotation.current(), far);
    EXPECT_EQ(rotation.next(1), near);
    rotation.advance(1);
    EXPECT_EQ(rotation.current(), near);
    EXPECT_EQ(rotation.next(1), far);
    rotation.advance(1);
  }
}

TEST(LevelRotation, FindsALevelByItsHash) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  const LevelRotation rotation({far, near});
  EXPECT_EQ(rotation.find(near->hash), near);
  EXPECT_EQ(rotation.find(near->hash + far->hash + 1), nullptr);
}

TEST(LevelRotation, ReplacingKeepsTheCurrentLevel) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far});
  rotation.replace({near});
  EXPECT_EQ(rotation.current(), far);
  EXPECT_EQ(rotation.find(far->hash), far);
  rotation.advance(1);
  EXPECT_EQ(rotation.current(), near);
  EXPECT_EQ(rotation.find(far->hash), nullptr);
}

TEST(LevelRotation, ReplacingStartsWithTheFirstNewLevel) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far, far});
  EXPECT_EQ(rotation.next(1), far);
  rotation.replace({near, far});
  EXPECT_EQ(rotation.next(1), near);
}

TEST(LevelRotation, UpdatingKeepsThePlace) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far, far});
  rotation.update({far, near});
  EXPECT_EQ(rotation.current(), far);
  EXPECT_EQ(rotation.next(1), near);
}

TEST(LevelRotation, SkipsLevelsThatNeedMorePlayers) {
  const LevelPointer alone = levelOf(farGoalText());
  const LevelPointer pair = levelOf("# players: 2\n" + nearGoalText());
  LevelRotation rotation({alone, pair, alone});
  EXPECT_EQ(rotation.next(2), pair);
  EXPECT_EQ(rotation.next(1), alone);
  rotation.advance(1);
  EXPECT_EQ(rotation.next(2), alone) << "the last one was played, so the first one comes";
  rotation.advance(1);
  EXPECT_EQ(rotation.next(2), pair);
}

// Before, who hosted a level for two played the one after it.
TEST(LevelRotation, StartsAtTheLevelThatWasChosenWhateverItNeeds) {
  const LevelPointer alone = levelOf(farGoalText());
  const LevelPointer pair = levelOf("# players: 2\n" + nearGoalText());
  EXPECT_EQ(LevelRotation({pair, alone}).current(), alone);
  LevelRotation chosen({pair, alone}, LevelRotation::Start::kFirst);
  EXPECT_EQ(chosen.current(), pair);
  chosen.advance(1);
  EXPECT_EQ(chosen.current(), alone);
  chosen.advance(1);
  EXPECT_EQ(chosen.current(), alone) << "later it is skipped";
}

TEST(LevelRotation, PlaysALevelForMorePlayersIfThereIsNoOther) {
  const LevelPointer pair = levelOf("# players: 2\n" + nearGoalText());
  LevelRotation rotation({pair});
  EXPECT_EQ(rotation.current(), pair);
  EXPECT_EQ(rotation.next(1), pair);
  EXPECT_EQ(rotation.next(0), pair);
}

}  // namespace
}  // namespace platon::level_rotation_test
