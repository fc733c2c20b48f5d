#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "levels/drawing/colour.h"

namespace platon {

/// What is painted on a ball; ball.frag draws it.
enum class BallPattern : std::uint8_t { kSpots, kStripes, kBelt, kCross, kDots, kHalves, kChecks, kPlain };
inline constexpr std::uint32_t kBallPatterns = 8;

/// Colours of balls, which differ in lightness for all eyes.
inline constexpr std::uint32_t kBallColours = 5;
/// `index` < kBallColours.
Colour ballColour(std::uint32_t index);

/// How the ball of a player looks.
struct BallLook {
  std::uint32_t colour = 0;  ///< index of ballColour
  BallPattern pattern = BallPattern::kSpots;

  friend bool operator==(const BallLook&, const BallLook&) = default;
};

/// The look of a player who has chosen none. Those of kBallColours · kBallPatterns successive slots differ.
BallLook lookOfSlot(std::uint32_t slot);

/// What the local player has chosen for its own ball.
struct BallChoice {
  std::optional<std::uint32_t> colour{};
  std::optional<BallPattern> pattern{};
};

/// The looks of players as the local player sees them: its own as it has chosen. Who would look the same has the look
/// of the local player's slot instead.
BallLook lookOf(std::uint32_t slot, std::optional<std::uint32_t> localSlot, const BallChoice& own);

/// Colour of a player who has chosen none.
Colour playerColour(std::uint32_t slot);

}  // namespace platon
