#include "client/scene/palette.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon {
namespace {

TEST(Palette, ColoursOfPlayersDiffer) {
  for (std::uint32_t a = 0; a < 20; ++a) {
    for (std::uint32_t b = 0; b < a; ++b)
      EXPECT_GT(glm::distance(playerColour(a), playerColour(b)), 0.04F) << a << " " << b;
  }
}

}  // namespace
}  // namespace platon
