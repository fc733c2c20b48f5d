#include "client/ui/ball_choice_text.h"

#include <gtest/gtest.h>

namespace platon::ball_choice_text_test {
namespace {

TEST(BallChoiceText, EachColourAndPatternIsReadAsItIsWritten) {
  for (std::uint32_t i = 0; i < kBallColours; ++i) {
    std::optional<std::uint32_t> colour;
    EXPECT_TRUE(parse(wordOf(std::optional(i)), colour));
    EXPECT_EQ(colour, i);
  }
  for (std::uint32_t i = 0; i < kBallPatterns; ++i) {
    std::optional<BallPattern> pattern;
    EXPECT_TRUE(parse(wordOf(std::optional(static_cast<BallPattern>(i))), pattern));
    EXPECT_EQ(pattern, static_cast<BallPattern>(i));
  }
}

TEST(BallChoiceText, AutoIsNone) {
  std::optional<std::uint32_t> colour = 2;
  EXPECT_TRUE(parse("auto", colour));
  EXPECT_FALSE(colour);
  EXPECT_EQ(wordOf(std::optional<BallPattern>()), "auto");
}

TEST(BallChoiceText, OtherWordsChangeNothing) {
  std::optional<std::uint32_t> colour = 2;
  for (const char* word : {"", "Orange", "7", "spots"}) EXPECT_FALSE(parse(word, colour)) << word;
  EXPECT_EQ(colour, 2U);
  EXPECT_EQ(ballColourWords(), "auto, orange, blue, green, rose, cream");
  EXPECT_EQ(ballPatternWords(), "auto, spots, stripes, belt, cross, dots, halves, checks, plain");
}

}  // namespace
}  // namespace platon::ball_choice_text_test
