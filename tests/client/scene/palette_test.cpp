#include "client/scene/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/client/scene/eyes.h"

namespace platon::palette_test {
namespace {

constexpr SolidKind kKinds[] = {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                                SolidKind::kDodecahedron, SolidKind::kIcosahedron};

TEST(Scheme, NeighbouringFacesHaveDifferentTones) {
  for (const SolidKind kind : kKinds) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    const std::vector<int>& tones = tonesOfFaces(kind);
    ASSERT_EQ(tones.size(), static_cast<std::size_t>(solid.faces()));
    for (int face = 0; face < solid.faces(); ++face) {
      const int tone = tones[static_cast<std::size_t>(face)];
      EXPECT_GE(tone, 0);
      EXPECT_LT(tone, Scheme::kTones);
      for (int edge = 0; edge < solid.edgesPerFace(); ++edge)
        EXPECT_NE(tone, tones[solid.neighbour(face, edge).face]) << "face " << face;
    }
  }
}

TEST(Scheme, TonesDifferByLightnessForAllEyes) {
  constexpr double kLeast = 7;  // a difference of 1 is just seen
  for (const SolidKind kind : kKinds) {
    for (const auto& eyes : {+[](glm::dvec3 c) { return c; }, &protanope, &deuteranope}) {
      const auto& tones = schemeOf(kind).tones;
      for (std::size_t i = 1; i < tones.size(); ++i) {
        EXPECT_GT(lightness(eyes(linear(tones[i]))), lightness(eyes(linear(tones[i - 1]))) + kLeast)
            << "solid " << static_cast<int>(kind) << " tone " << i;
      }
    }
  }
}

TEST(Scheme, NeighbouringFacesHaveClearlyDifferentColoursForAllEyes) {
  const auto usual = +[](glm::dvec3 c) { return c; };
  for (const SolidKind kind : kKinds) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    const auto colourOf = [&](int face) {
      const int tone = tonesOfFaces(kind)[static_cast<std::size_t>(face)];
      return linear(schemeOf(kind).tones[static_cast<std::size_t>(tone)]);
    };
    for (int face = 0; face < solid.faces(); ++face) {
      for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
        const int next = solid.neighbour(face, edge).face;
        for (const auto& [eyes, least] : {std::pair(usual, 12.0), {&protanope, 8.0}, {&deuteranope, 8.0}}) {
          EXPECT_GT(glm::distance(lab(eyes(colourOf(face))), lab(eyes(colourOf(next)))), least)
              << "solid " << static_cast<int>(kind) << " faces " << face << " and " << next;
        }
      }
    }
  }
}

TEST(Scheme, SolidsDiffer) {
  for (const SolidKind a : kKinds) {
    for (const SolidKind b : kKinds) {
      if (a == b) continue;
      EXPECT_GT(glm::distance(schemeOf(a).tones[1], schemeOf(b).tones[1]), 0.05F);
      EXPECT_GT(glm::distance(schemeOf(a).skyBottom, schemeOf(b).skyBottom), 0.05F);
    }
  }
}

TEST(Scheme, WallsAndPlayersAreLighterThanFaces) {
  for (const SolidKind kind : kKinds) {
    const Scheme& scheme = schemeOf(kind);
    const double lightest = lightness(linear(scheme.tones.back()));
    EXPECT_GT(lightness(linear(scheme.wall)), lightest + 25);
    for (std::uint32_t slot = 0; slot < 64; ++slot) EXPECT_GT(lightness(linear(playerColour(slot))), lightest) << slot;
  }
}

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

constexpr std::uint32_t kAppearances = kBallColours * kBallPatterns;

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
void expectDifferent(const std::vector<BallAppearance>& appearances) {
  for (std::size_t a = 0; a < appearances.size(); ++a) {
    EXPECT_LT(appearances[a].colour, kBallColours);
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(appearances[a], appearances[b]) << a << " " << b;
  }
}

TEST(Palette, AnyTwoPlayersDiffer) {
  std::vector<BallAppearance> appearances;
  for (std::uint32_t slot = 0; slot < kAppearances; ++slot) appearances.push_back(appearanceOfSlot(slot));
  expectDifferent(appearances);
}

TEST(Palette, AnyTwoPlayersDifferWhateverTheLocalPlayerHasChosen) {
  for (std::uint32_t choice = 0; choice < kAppearances; ++choice) {
    const BallChoice own{choice % kBallColours, static_cast<BallPattern>(choice / kBallColours)};
    const std::uint32_t local = choice * 7 % kAppearances;
    std::vector<BallAppearance> appearances;
    for (std::uint32_t slot = 0; slot < kAppearances; ++slot)
      appearances.push_back(appearanceOf(slot, std::array{OwnBall{local, own}}));
    EXPECT_EQ(appearances[local], (BallAppearance{*own.colour, *own.pattern}));
    expectDifferent(appearances);
  }
}

// Four who choose among few colours, so that each often wants what another one has.
TEST(Palette, AnyTwoPlayersDifferWhateverSeveralLocalPlayersHaveChosen) {
  for (std::uint32_t choice = 0; choice < 81; ++choice) {
    std::vector<OwnBall> own;
    for (std::uint32_t i = 0, rest = choice; i < 4; ++i, rest /= 3)
      own.push_back({i * 5 % 7, {rest % 3, BallPattern::kSpots}});
    std::vector<BallAppearance> appearances;
    for (std::uint32_t slot = 0; slot < kAppearances; ++slot) appearances.push_back(appearanceOf(slot, own));
    EXPECT_EQ(appearances[own[3].slot], (BallAppearance{*own[3].choice.colour, BallPattern::kSpots})) << choice;
    expectDifferent(appearances);
  }
}

TEST(Palette, AChoiceMayBeOfTheColourOrThePatternAlone) {
  EXPECT_EQ(appearanceOf(3, std::array{OwnBall{3, {}}}), appearanceOfSlot(3));
  EXPECT_EQ(appearanceOf(3, std::array{OwnBall{3, {.colour = 1}}}), (BallAppearance{1, appearanceOfSlot(3).pattern}));
  EXPECT_EQ(appearanceOf(3, std::array{OwnBall{3, {.pattern = BallPattern::kBelt}}}),
            (BallAppearance{appearanceOfSlot(3).colour, BallPattern::kBelt}));
  EXPECT_EQ(appearanceOf(4, std::array{OwnBall{3, {}}}), appearanceOfSlot(4));
}

}  // namespace

}  // namespace platon::palette_test
