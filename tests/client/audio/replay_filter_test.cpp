#include "client/audio/replay_filter.h"

#include <gtest/gtest.h>

namespace platon::replay_filter_test {
namespace {

TEST(ReplayFilter, AnEventPassesAgainOnlyAfterTheTime) {
  ReplayFilter filter;
  EXPECT_TRUE(filter.passes(1, 100, 10));
  EXPECT_FALSE(filter.passes(1, 101, 10));
  EXPECT_FALSE(filter.passes(1, 109, 10));
  EXPECT_TRUE(filter.passes(1, 110, 10));
}

TEST(ReplayFilter, KeysDoNotAffectEachOther) {
  ReplayFilter filter;
  EXPECT_TRUE(filter.passes(1, 0, 10));
  EXPECT_TRUE(filter.passes(2, 0, 10));
  EXPECT_FALSE(filter.passes(2, 1, 10));
}

}  // namespace
}  // namespace platon::replay_filter_test
