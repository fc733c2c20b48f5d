#include "client/scene/palette.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/client/scene/eyes.h"

namespace platon::palette_test {
namespace {

constexpr std::uint32_t kLooks = kBallColours * kBallPatterns;

TEST(Palette, ColoursDifferInLightnessForAllEyes) {
  constexpr double kLeast = 4;  // a difference of 1 is just seen
  for (const auto& eyes : {+[](glm::dvec3 c) { return c; }, &protanope, &deuteranope}) {
    for (std::uint32_t a = 0; a < kBallColours; ++a) {
      for (std::uint32_t b = 0; b < a; ++b) {
        EXPECT_GT(std::abs(lightness(eyes(linear(ballColour(a)))) - lightness(eyes(linear(ballColour(b))))), kLeast)
            << a << " " << b;
      }
    }
  }
}

// Which differ in lightness or pattern.
void expectDifferent(const std::vector<BallLook>& looks) {
  for (std::size_t a = 0; a < looks.size(); ++a) {
    EXPECT_LT(looks[a].colour, kBallColours);
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(looks[a], looks[b]) << a << " " << b;
  }
}

TEST(Palette, AnyTwoPlayersDiffer) {
  std::vector<BallLook> looks;
  for (std::uint32_t slot = 0; slot < kLooks; ++slot) looks.push_back(lookOfSlot(slot));
  expectDifferent(looks);
}

TEST(Palette, AnyTwoPlayersDifferWhateverTheLocalPlayerHasChosen) {
  for (std::uint32_t choice = 0; choice < kLooks; ++choice) {
    const BallChoice own{choice % kBallColours, static_cast<BallPattern>(choice / kBallColours)};
    const std::uint32_t local = choice * 7 % kLooks;
    std::vector<BallLook> looks;
    for (std::uint32_t slot = 0; slot < kLooks; ++slot) looks.push_back(lookOf(slot, local, own));
    EXPECT_EQ(looks[local], (BallLook{*own.colour, *own.pattern}));
    expectDifferent(looks);
  }
}

TEST(Palette, AChoiceMayBeOfTheColourOrThePatternAlone) {
  EXPECT_EQ(lookOf(3, 3, {}), lookOfSlot(3));
  EXPECT_EQ(lookOf(3, 3, {.colour = 1}), (BallLook{1, lookOfSlot(3).pattern}));
  EXPECT_EQ(lookOf(3, 3, {.pattern = BallPattern::kBelt}), (BallLook{lookOfSlot(3).colour, BallPattern::kBelt}));
  EXPECT_EQ(lookOf(4, 3, {}), lookOfSlot(4));
}

}  // namespace
}  // namespace platon::palette_test
