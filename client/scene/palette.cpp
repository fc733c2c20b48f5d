#include "client/scene/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

constexpr double kDarkest = 0.36;
constexpr double kStep = 0.085;  // of lightness from tone to tone
constexpr std::size_t kSolids = 5;

// In the colour space of oklch().
struct Shade {
  double lightness;
  double chroma;
  double hue;
};

struct Plan {
  double chroma;  // of the tones
  double hue;     // of the darkest tone
  double turn;    // of the hue from tone to tone
  Shade wall;
  Shade skyTop;
  Shade skyBottom;
  Shade glow;
  Shade mote;
};

Colour colourOf(const Shade& shade) { return oklch(shade.lightness, shade.chroma, shade.hue); }

const Plan& planOf(SolidKind solid) {
  static const Plan fire{
      0.115, 8, 18, {0.95, 0.035, 75}, {0.25, 0.06, 320}, {0.50, 0.09, 15}, {0.84, 0.10, 75}, {0.85, 0.13, 75}};
  static const Plan earth{
      0.078, 188, -27, {0.96, 0.03, 95}, {0.30, 0.055, 225}, {0.60, 0.075, 75}, {0.78, 0.09, 80}, {0.92, 0.07, 95}};
  static const Plan air{
      0.085, 284, -20, {0.97, 0.015, 250}, {0.36, 0.09, 270}, {0.62, 0.07, 340}, {0.80, 0.06, 25}, {0.96, 0.02, 250}};
  static const Plan ether{
      0.10, 275, 22, {0.95, 0.025, 320}, {0.21, 0.08, 285}, {0.46, 0.10, 345}, {0.66, 0.11, 10}, {0.88, 0.07, 320}};
  static const Plan water{
      0.085, 256, -22, {0.96, 0.02, 200}, {0.21, 0.07, 270}, {0.50, 0.075, 205}, {0.70, 0.075, 175}, {0.90, 0.06, 190}};
  switch (solid) {
    case SolidKind::kTetrahedron:
      return fire;
    case SolidKind::kHexahedron:
      return earth;
    case SolidKind::kOctahedron:
      return air;
    case SolidKind::kDodecahedron:
      return ether;
    default:
      return water;
  }
}

Scheme made(const Plan& plan) {
  Scheme scheme;
  for (int tone = 0; tone < Scheme::kTones; ++tone)
    scheme.tones[static_cast<std::size_t>(tone)] =
        oklch(kDarkest + kStep * tone, plan.chroma, plan.hue + plan.turn * tone);
  scheme.wall = colourOf(plan.wall);
  scheme.skyTop = colourOf(plan.skyTop);
  scheme.skyBottom = colourOf(plan.skyBottom);
  scheme.glow = colourOf(plan.glow);
  scheme.mote = colourOf(plan.mote);
  return scheme;
}

bool fits(const PlatonicSolid& solid, const std::vector<int>& tones, int face, int tone) {
  for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
    if (tones[solid.neighbour(face, edge).face] == tone) return false;
  }
  return true;
}

// Gives tones to `face` and all after it. Each face begins with another tone, so that all tones are used.
bool giveTones(const PlatonicSolid& solid, std::vector<int>& tones, int face) {
  if (face == solid.faces()) return true;
  int& own = tones[static_cast<std::size_t>(face)];
  for (int i = 0; i < Scheme::kTones; ++i) {
    const int tone = (2 + 3 * face + i) % Scheme::kTones;
    if (!fits(solid, tones, face, tone)) continue;
    own = tone;
    if (giveTones(solid, tones, face + 1)) return true;
    own = -1;
  }
  return false;
}

template <class Value, class Make>
const Value& perSolid(SolidKind solid, Make make) {
  static const std::array<Value, kSolids> values = [&] {
    std::array<Value, kSolids> all;
    for (std::size_t i = 0; i < kSolids; ++i) all[i] = make(static_cast<SolidKind>(i));
    return all;
  }();
  return values[static_cast<std::size_t>(solid)];
}

}  // namespace

const Scheme& schemeOf(SolidKind solid) {
  return perSolid<Scheme>(solid, [](SolidKind kind) { return made(planOf(kind)); });
}

const std::vector<int>& tonesOfFaces(SolidKind solid) {
  return perSolid<std::vector<int>>(solid, [](SolidKind kind) {
    const PlatonicSolid& faces = PlatonicSolid::of(kind);
    std::vector<int> tones(static_cast<std::size_t>(faces.faces()), -1);
    giveTones(faces, tones, 0);
    return tones;
  });
}

namespace {

constexpr float kGamma = 2.2F;
constexpr float kShare = 0.08F;  // of the light of a face that is left

}  // namespace

Scheme highContrast(const Scheme& scheme) {
  Scheme plain;
  for (std::size_t i = 0; i < plain.tones.size(); ++i) plain.tones[i] = highContrastFace(scheme.tones[i]);
  plain.skyTop = plain.skyBottom = plain.glow = Colour(0);
  return plain;
}

Colour highContrastFace(Colour face) {
  const float light = glm::dot(glm::pow(face, Colour(kGamma)), Colour(0.2126F, 0.7152F, 0.0722F));
  return Colour(std::pow(kShare * light, 1 / kGamma));
}

Colour ballColour(std::uint32_t index) {
  static const std::array<Colour, kBallColours> colours{oklch(0.85, 0.15, 76), oklch(0.735, 0.12, 240),
                                                        oklch(0.90, 0.16, 135), oklch(0.68, 0.13, 350),
                                                        oklch(0.97, 0.06, 105)};
  return colours[index];
}

BallAppearance appearanceOfSlot(std::uint32_t slot) {
  return {slot % kBallColours, static_cast<BallPattern>((slot / kBallColours + slot % kBallColours) % kBallPatterns)};
}

BallAppearance appearanceOf(std::uint32_t slot, std::span<const OwnBall> own) {
  std::vector<BallAppearance> owners;
  for (const OwnBall& ball : own) owners.push_back(appearanceOfSlot(ball.slot));
  BallAppearance other = appearanceOfSlot(slot);
  const BallAppearance* asked = &other;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].slot == slot) asked = &owners[i];
    const BallAppearance before = owners[i];
    const BallAppearance bySlot = appearanceOfSlot(own[i].slot);
    const BallChoice& choice = own[i].choice;
    const BallAppearance chosen{choice.colour.value_or(bySlot.colour), choice.pattern.value_or(bySlot.pattern)};
    if (!choice.colour && !choice.pattern) continue;
    for (BallAppearance& each : owners)
      if (each == chosen) each = before;
    if (other == chosen) other = before;
    owners[i] = chosen;
  }
  return *asked;
}

Colour playerColour(std::uint32_t slot) { return ballColour(appearanceOfSlot(slot).colour); }

}  // namespace platon
