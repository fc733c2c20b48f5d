#include "client/quality/quality.h"

#include <gtest/gtest.h>

namespace platon::quality_test {
namespace {

TEST(Quality, EachLevelIsAtItsPlaceAndHasItsName) {
  for (std::size_t i = 0; i < kQualities.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kQualities[i].level), i);
    EXPECT_EQ(qualityLevelOf(kQualities[i].name), kQualities[i].level);
    EXPECT_EQ(&namedQuality(kQualities[i].level), &kQualities[i]);
  }
  EXPECT_EQ(qualityLevelOf(""), std::nullopt);
  EXPECT_EQ(qualityLevelOf("High"), std::nullopt);
}

TEST(Quality, EachLevelDrawsAtLeastWhatTheOneBeforeDraws) {
  for (std::size_t i = 1; i < kQualities.size(); ++i) {
    const Quality& less = kQualities[i - 1].quality;
    const Quality& more = kQualities[i].quality;
    EXPECT_LE(less.samples, more.samples);
    EXPECT_LE(less.scale, more.scale);
    EXPECT_LE(less.particles, more.particles);
    EXPECT_LE(less.fine, more.fine);
    EXPECT_NE(less, more);
  }
}

TEST(Quality, EveryLevelIsDrawnAtThreeQuartersOfTheSizeOrMore) {
  for (const NamedQuality& named : kQualities) {
    EXPECT_GE(named.quality.scale, 0.75);
    EXPECT_LE(named.quality.samples, Quality::kMaxSamples);
  }
}

TEST(Quality, TheLastLevelHasEverythingOn) { EXPECT_EQ(kBestQuality, (Quality{4, 1, true, true})); }

}  // namespace
}  // namespace platon::quality_test
