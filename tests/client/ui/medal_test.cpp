#include "client/ui/medal.h"

#include <gtest/gtest.h>

namespace platon::medal_test {
namespace {

TEST(Medal, TimesFollowFromTheWayAndAreTenthsOfASecond) {
  const MedalTimes times = medalTimesOf(600);
  EXPECT_EQ(times.gold, 690U);
  EXPECT_EQ(times.silver, 900U);
  EXPECT_EQ(times.bronze, 1500U);
  for (std::uint32_t way = 1; way < 2000; ++way) {
    const MedalTimes each = medalTimesOf(way);
    EXPECT_GE(each.gold * 100, way * 115);
    EXPECT_LT(each.gold * 100, way * 115 + 600);
    EXPECT_EQ(each.gold % 6 + each.silver % 6 + each.bronze % 6, 0U);
    EXPECT_TRUE(each.gold <= each.silver && each.silver <= each.bronze);
  }
}

TEST(Medal, TheTimeOfAMedalGivesIt) {
  const MedalTimes times = medalTimesOf(600);
  EXPECT_EQ(medalFor(times, 690), Medal::kGold);
  EXPECT_EQ(medalFor(times, 691), Medal::kSilver);
  EXPECT_EQ(medalFor(times, 901), Medal::kBronze);
  EXPECT_EQ(medalFor(times, 1501), Medal::kNone);
}

TEST(Medal, HasAFormAndAColour) {
  EXPECT_EQ(starsOf(Medal::kGold), "★★★");
  EXPECT_EQ(starsOf(Medal::kSilver), "★★☆");
  EXPECT_EQ(starsOf(Medal::kBronze), "★☆☆");
  EXPECT_EQ(starsOf(Medal::kNone), "☆☆☆");
  EXPECT_EQ(starsOf({}), "★") << "a level without medals";
  EXPECT_NE(colourOf(Medal::kGold), colourOf(Medal::kSilver));
  EXPECT_NE(colourOf(Medal::kSilver), colourOf(Medal::kBronze));
  EXPECT_NE(colourOf(Medal::kBronze), colourOf(Medal::kNone));
}

TEST(Medal, TheNextOneIsNamedWithItsTime) {
  const MedalTimes times = medalTimesOf(600);
  EXPECT_EQ(nextMedalText(times, std::nullopt), "bronze: 25.00 s");
  EXPECT_EQ(nextMedalText(times, 1600), "bronze: 25.00 s");
  EXPECT_EQ(nextMedalText(times, 1500), "silver: 15.00 s");
  EXPECT_EQ(medalText(times, 900), "★★☆ silver, gold: 11.50 s");
  EXPECT_EQ(medalText(times, 1600), "bronze: 25.00 s");
  EXPECT_EQ(medalText(times, 1), "★★★ gold");
}

}  // namespace
}  // namespace platon::medal_test
