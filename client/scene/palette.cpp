#include "client/scene/palette.h"

namespace platon {

Colour ballColour(std::uint32_t index) {
  static const std::array<Colour, kBallColours> colours{oklch(0.85, 0.15, 76), oklch(0.735, 0.12, 240),
                                                        oklch(0.90, 0.16, 135), oklch(0.68, 0.13, 350),
                                                        oklch(0.97, 0.06, 105)};
  return colours[index];
}

BallLook lookOfSlot(std::uint32_t slot) {
  return {slot % kBallColours, static_cast<BallPattern>((slot / kBallColours + slot % kBallColours) % kBallPatterns)};
}

BallLook lookOf(std::uint32_t slot, std::optional<std::uint32_t> localSlot, const BallChoice& own) {
  const BallLook look = lookOfSlot(slot);
  if (!localSlot) return look;
  const BallLook bySlot = lookOfSlot(*localSlot);
  const BallLook chosen{own.colour.value_or(bySlot.colour), own.pattern.value_or(bySlot.pattern)};
  if (slot == *localSlot) return chosen;
  return look == chosen ? bySlot : look;
}

Colour playerColour(std::uint32_t slot) { return ballColour(lookOfSlot(slot).colour); }

}  // namespace platon
