#include "server/match/level_rotation.h"

#include <gtest/gtest.h>

#include "tests/support/test_levels.h"

namespace platon {
namespace {

TEST(LevelRotation, StartsOverAfterTheLastLevel) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far, near});
  for (int lap = 0; lap < 2; ++lap) {
    EXPECT_EQ(rotation.current(), far);
    EXPECT_EQ(rotation.next(), near);
    rotation.advance();
    EXPECT_EQ(rotation.current(), near);
    EXPECT_EQ(rotation.next(), far);
    rotation.advance();
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
  rotation.advance();
  EXPECT_EQ(rotation.current(), near);
  EXPECT_EQ(rotation.find(far->hash), nullptr);
}

TEST(LevelRotation, ReplacingStartsWithTheFirstNewLevel) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far, far});
  EXPECT_EQ(rotation.next(), far);
  rotation.replace({near, far});
  EXPECT_EQ(rotation.next(), near);
}

TEST(LevelRotation, UpdatingKeepsThePlace) {
  const LevelPointer far = levelOf(farGoalText());
  const LevelPointer near = levelOf(nearGoalText());
  LevelRotation rotation({far, far});
  rotation.update({far, near});
  EXPECT_EQ(rotation.current(), far);
  EXPECT_EQ(rotation.next(), near);
}

}  // namespace
}  // namespace platon
