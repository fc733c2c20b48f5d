#include "client/scene/look/scheme.h"

#include <cstddef>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/scene/palette.h"
#include "tests/client/scene/eyes.h"

namespace platon::scheme_test {
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

}  // namespace
}  // namespace platon::scheme_test
