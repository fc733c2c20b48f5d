#include "levels/drawing/colour.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon::colour_test {
namespace {

TEST(Colour, OklchGivesKnownColours) {
  EXPECT_LT(glm::distance(oklch(1, 0, 0), Colour(1)), 1e-3F);
  EXPECT_LT(glm::distance(oklch(0, 0, 0), Colour(0)), 1e-3F);
  // Red of sRGB by the definition of Oklab.
  EXPECT_LT(glm::distance(oklch(0.62796, 0.25768, 29.234), Colour(1, 0, 0)), 2e-3F);
}

TEST(Colour, ColoursAreClampedToTheGamut) {
  for (int hue = 0; hue < 360; hue += 5) {
    const Colour colour = oklch(0.9, 0.4, hue);
    EXPECT_EQ(colour, glm::clamp(colour, 0.0F, 1.0F)) << hue;
  }
}

}  // namespace
}  // namespace platon::colour_test
