#include "client/scene/palette.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

TEST(Palette, ColoursOfFacesAndOfPlayersDiffer) {
  for (int a = 0; a < 20; ++a) {
    for (int b = 0; b < a; ++b) {
      EXPECT_GT(glm::distance(faceColour(a), faceColour(b)), 0.02F) << a << " " << b;
      const auto slotA = static_cast<std::uint32_t>(a);
      EXPECT_GT(glm::distance(playerColour(slotA), playerColour(static_cast<std::uint32_t>(b))), 0.04F)
          << a << " " << b;
    }
  }
}

TEST(Palette, PlayersAreBrighterThanFaces) {
  const auto luma = [](Colour colour) { return glm::dot(colour, Colour(0.2126F, 0.7152F, 0.0722F)); };
  float brightestFace = 0;
  for (int face = 0; face < 20; ++face) brightestFace = glm::max(brightestFace, luma(faceColour(face)));
  for (std::uint32_t slot = 0; slot < 64; ++slot) EXPECT_GT(luma(playerColour(slot)), brightestFace) << slot;
}

}  // namespace
}  // namespace platon
