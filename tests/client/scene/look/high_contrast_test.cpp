#include "client/scene/look/high_contrast.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "client/scene/palette.h"
#include "tests/client/scene/eyes.h"

namespace platon::high_contrast_test {
namespace {

constexpr SolidKind kKinds[] = {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                                SolidKind::kDodecahedron, SolidKind::kIcosahedron};

// Of the Web Content Accessibility Guidelines, 1 … 21.
double contrastRatio(Colour a, Colour b) {
  const auto light = [](Colour colour) { return luminance(linear(colour)) + 0.05; };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

TEST(HighContrast, WallsGoalAndPlayersStandOutFromEachFaceAndTheSky) {
  const Colour gold(1.0F, 0.84F, 0.36F);  // of the goal
  for (const SolidKind kind : kKinds) {
    const Scheme scheme = highContrast(schemeOf(kind));
    for (const Colour ground : {scheme.tones[0], scheme.tones[1], scheme.tones[2], scheme.tones[3], scheme.skyTop,
                                scheme.skyBottom, scheme.glow}) {
      EXPECT_GT(contrastRatio(scheme.wall, ground), 12);
      EXPECT_GT(contrastRatio(gold, ground), 7);
      for (std::uint32_t slot = 0; slot < 64; ++slot) EXPECT_GT(contrastRatio(playerColour(slot), ground), 4.5) << slot;
    }
  }
}

TEST(HighContrast, FacesStillDifferInLightness) {
  for (const SolidKind kind : kKinds) {
    const Scheme scheme = highContrast(schemeOf(kind));
    for (std::size_t i = 1; i < scheme.tones.size(); ++i)
      EXPECT_GT(lightness(linear(scheme.tones[i])), lightness(linear(scheme.tones[i - 1])) + 1);
  }
}

}  // namespace
}  // namespace platon::high_contrast_test
