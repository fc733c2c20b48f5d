#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "levels/drawing/colour.h"
#include "platon/game/solid.h"

namespace platon {

/// The colours of a solid and of the sky round it. Each solid has those of its element in Plato's Timaeus: fire for the
/// tetrahedron, earth for the hexahedron, air for the octahedron, ether for the dodecahedron and water for the
/// icosahedron.
struct Scheme {
  static constexpr int kTones = 4;

  std::array<Colour, kTones> tones{};  ///< of faces, from dark to light, also for eyes that lack a kind of cones
  Colour wall{1};
  Colour skyTop{0};
  Colour skyBottom{0};
  Colour glow{0};  ///< in the sky behind the solid
  Colour mote{1};  ///< of the particles in the sky
};

const Scheme& schemeOf(SolidKind solid);

/// The tone of each face: no two neighbours have the same.
const std::vector<int>& tonesOfFaces(SolidKind solid);

/// The scheme with high contrast: a black sky, white walls and almost black faces, which still differ in lightness.
Scheme highContrast(const Scheme& scheme);

/// The colour of a face with high contrast, from that without.
Colour highContrastFace(Colour face);

/// What is painted on a ball; ball.frag draws it.
enum class BallPattern : std::uint8_t { kSpots, kStripes, kBelt, kCross, kDots, kHalves, kChecks, kPlain };
inline constexpr std::uint32_t kBallPatterns = 8;

/// Colours of balls, which differ in lightness for all eyes.
inline constexpr std::uint32_t kBallColours = 5;
/// `index` < kBallColours.
Colour ballColour(std::uint32_t index);

/// What the ball of a player looks like.
struct BallAppearance {
  std::uint32_t colour = 0;  ///< index of ballColour
  BallPattern pattern = BallPattern::kSpots;

  friend bool operator==(const BallAppearance&, const BallAppearance&) = default;
};

/// The appearance of a player who has chosen none. Those of kBallColours · kBallPatterns successive slots differ.
BallAppearance appearanceOfSlot(std::uint32_t slot);

/// What the local player has chosen for its own ball.
struct BallChoice {
  std::optional<std::uint32_t> colour{};
  std::optional<BallPattern> pattern{};
};

/// What a local player has chosen for its ball.
struct OwnBall {
  std::uint32_t slot = 0;
  BallChoice choice;
};

/// The appearance of a player as the local players see it: their own as they have chosen, the first one first. Who
/// would look the same as one of them has instead what that one had before.
BallAppearance appearanceOf(std::uint32_t slot, std::span<const OwnBall> own);

/// Colour of a player who has chosen none.
Colour playerColour(std::uint32_t slot);

}  // namespace platon
