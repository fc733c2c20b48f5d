#include "levels/picture/tints.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace platon::tints_test {
namespace {

class TintsTest : public testing::TestWithParam<int> {
 protected:
  Tints tints() const { return Tints(static_cast<SolidKind>(GetParam())); }
};

float luma(Colour colour) { return glm::dot(colour, Colour(0.2126F, 0.7152F, 0.0722F)); }

TEST_P(TintsTest, InkAndMarksStandOutFromFacesAndBackground) {
  for (double brightness = 0; brightness <= 1; brightness += 0.125) {
    EXPECT_GT(luma(tints().face(brightness)) - luma(tints().ink()), 0.3F) << brightness;
    EXPECT_GT(luma(tints().face(brightness)) - luma(Tints::start()), 0.08F) << brightness;
    EXPECT_GT(luma(tints().face(brightness)) - luma(Tints::goal()), 0.1F) << brightness;
  }
  EXPECT_GT(luma(tints().background()) - luma(tints().ink()), 0.6F);
}

TEST_P(TintsTest, MoreLightMakesAFaceBrighter) {
  for (int step = 0; step < 8; ++step) {
    EXPECT_LT(luma(tints().face(step / 8.0)), luma(tints().face((step + 1) / 8.0))) << step;
  }
  EXPECT_LT(luma(tints().face(1)), luma(tints().background()));
}

TEST_P(TintsTest, SolidsHaveDifferentTints) {
  for (int other = 0; other < GetParam(); ++other) {
    const Tints others(static_cast<SolidKind>(other));
    EXPECT_GT(glm::distance(tints().face(0.5), others.face(0.5)), 0.08F) << other;
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolids, TintsTest, testing::Range(0, kSolidKinds));

}  // namespace
}  // namespace platon::tints_test
