#include "client/ui/skip_question.h"

#include <gtest/gtest.h>

namespace platon::skip_question_test {
namespace {

TEST(SkipQuestion, TheSecondWishLeavesAnUnfinishedLevel) {
  SkipQuestion question;
  EXPECT_FALSE(question.wish(false));
  EXPECT_TRUE(question.asked());
  EXPECT_TRUE(question.wish(false));
  EXPECT_FALSE(question.asked());
  EXPECT_FALSE(question.wish(false)) << "the next level is asked about anew";
}

TEST(SkipQuestion, AnythingElseTakesTheWishBack) {
  SkipQuestion question;
  question.wish(false);
  question.takeBack();
  EXPECT_FALSE(question.asked());
  EXPECT_FALSE(question.wish(false));
}

TEST(SkipQuestion, AfterTheGoalNothingIsAsked) {
  SkipQuestion question;
  EXPECT_TRUE(question.wish(true));
  EXPECT_FALSE(question.asked());
  question.wish(false);
  EXPECT_TRUE(question.wish(true)) << "the goal was reached meanwhile";
  EXPECT_FALSE(question.asked());
}

}  // namespace
}  // namespace platon::skip_question_test
