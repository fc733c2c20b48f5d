#include "client/session/known_levels.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/support/test_levels.h"

namespace platon::known_levels_test {
namespace {

// Levels that differ in their titles.
std::shared_ptr<const Level> levelOfNumber(std::size_t number) {
  return loadLevel("# title: " + std::to_string(number) + "\n" + std::string(endlessLevel()->text)).level;
}

LevelChunk chunkOf(std::uint64_t hash, std::string_view text) {
  return {hash, static_cast<std::uint32_t>(text.size()), 0, {text.begin(), text.end()}};
}

class KnownLevelsTest : public testing::Test {
 protected:
  KnownLevels::Receipt receive(const Level& level) { return levels_.receive(chunkOf(level.hash, level.text), work_); }

  KnownLevels levels_{{}, nullptr};
  WorkLimit work_{Time(0)};
};

TEST_F(KnownLevelsTest, ALevelIsLackedUntilItIsRequestedAndKnownOnceItHasCome) {
  const std::uint64_t hash = endlessLevel()->hash;
  EXPECT_TRUE(levels_.lacks(hash, work_));
  EXPECT_TRUE(levels_.request(hash));
  EXPECT_FALSE(levels_.lacks(hash, work_));
  EXPECT_EQ(levels_.find(hash, work_), nullptr);
  EXPECT_EQ(receive(*endlessLevel()), KnownLevels::Receipt::kLevel);
  ASSERT_NE(levels_.find(hash, work_), nullptr);
  EXPECT_EQ(levels_.find(hash, work_)->text, endlessLevel()->text);
  EXPECT_FALSE(levels_.lacks(hash, work_));
}

TEST_F(KnownLevelsTest, TheFirstLevelComesWithoutARequest) {
  levels_.expectFirst(endlessLevel()->hash, work_);
  EXPECT_EQ(receive(*endlessLevel()), KnownLevels::Receipt::kLevel);
}

TEST_F(KnownLevelsTest, AnAnnouncedFirstLevelDoesNotComeByItself) {
  KnownLevels levels({endlessLevel()}, nullptr);
  levels.expectFirst(endlessLevel()->hash, work_);
  const LevelChunk chunk = chunkOf(endlessLevel()->hash, endlessLevel()->text);
  EXPECT_EQ(levels.receive(chunk, work_), KnownLevels::Receipt::kNone);
}

TEST_F(KnownLevelsTest, ALevelThatWasNotRequestedIsIgnored) {
  levels_.request(endlessLevel()->hash);
  EXPECT_EQ(receive(*cornerLevel()), KnownLevels::Receipt::kNone);
  EXPECT_EQ(receive(*endlessLevel()), KnownLevels::Receipt::kLevel);
  EXPECT_EQ(levels_.levels().size(), 1u);
}

TEST_F(KnownLevelsTest, AnotherLevelUnderTheHashIsInvalid) {
  levels_.request(99);
  EXPECT_EQ(levels_.receive(chunkOf(99, cornerLevel()->text), work_), KnownLevels::Receipt::kInvalid);
  EXPECT_TRUE(levels_.levels().empty());
}

TEST_F(KnownLevelsTest, OnlySoManyRequestsMayBeUnanswered) {
  for (std::uint64_t hash = 1; hash <= KnownLevels::kMaxUnansweredRequests; ++hash) EXPECT_TRUE(levels_.request(hash));
  EXPECT_FALSE(levels_.request(endlessLevel()->hash));
  EXPECT_EQ(receive(*endlessLevel()), KnownLevels::Receipt::kNone) << "it has not been requested";
}

TEST_F(KnownLevelsTest, OfManyLevelsTheOldestIsForgotten) {
  std::vector<std::shared_ptr<const Level>> earlier;
  for (std::size_t i = 0; i < kMaxLevelsKnown; ++i) earlier.push_back(levelOfNumber(i));
  KnownLevels levels(earlier, nullptr);
  const std::shared_ptr<const Level> next = levelOfNumber(kMaxLevelsKnown);
  levels.request(next->hash);
  EXPECT_EQ(levels.receive(chunkOf(next->hash, next->text), work_), KnownLevels::Receipt::kLevel);
  ASSERT_EQ(levels.levels().size(), kMaxLevelsKnown);
  EXPECT_EQ(levels.levels().front()->hash, earlier[1]->hash);
  EXPECT_EQ(levels.levels().back()->hash, next->hash);
}

}  // namespace
}  // namespace platon::known_levels_test
