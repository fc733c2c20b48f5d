#include "client/scene/palette.h"

namespace platon {
namespace {

// Multiples of the golden angle spread any number of hues, in degrees.
constexpr double kGoldenAngle = 137.50776405003785;

}  // namespace

Colour playerColour(std::uint32_t slot) { return oklch(slot % 3 == 1 ? 0.70 : 0.80, 0.17, 70 + kGoldenAngle * slot); }

}  // namespace platon
