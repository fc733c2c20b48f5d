#include "levels/picture/tints.h"

namespace platon {
namespace {

double hueOf(SolidKind kind) {
  switch (kind) {
    case SolidKind::kTetrahedron:
      return 65;
    case SolidKind::kHexahedron:
      return 22;
    case SolidKind::kOctahedron:
      return 170;
    case SolidKind::kDodecahedron:
      return 300;
    default:
      return 235;
  }
}

}  // namespace

Tints::Tints(SolidKind kind) : hue_(hueOf(kind)) {}

Colour Tints::background() const { return oklch(0.978, 0.008, hue_ + 30); }

Colour Tints::ink() const { return oklch(0.34, 0.06, hue_ - 20); }

// Towards the light, the hue turns warmer.
Colour Tints::face(double brightness) const {
  return oklch(0.72 + 0.21 * brightness, 0.10 - 0.05 * brightness, hue_ - 30 + 45 * brightness);
}

Colour Tints::start() { return oklch(0.66, 0.19, 38); }

Colour Tints::goal() { return oklch(0.55, 0.12, 165); }

Colour Tints::up() { return oklch(0.45, 0.13, 255); }

Colour Tints::hazard() { return oklch(0.50, 0.20, 25); }

Colour Tints::checkpoint() { return oklch(0.48, 0.12, 235); }

Colour Tints::lock() { return oklch(0.52, 0.11, 80); }

Colour Tints::plate() { return oklch(0.48, 0.15, 310); }

}  // namespace platon
