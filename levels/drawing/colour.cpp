#include "levels/drawing/colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platon {
namespace {

double gammaEncoded(double linear) {
  const double value = std::clamp(linear, 0.0, 1.0);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

double cubed(double value) { return value * value * value; }

}  // namespace

Colour oklch(double lightness, double chroma, double hue) {
  const double radians = hue * std::numbers::pi / 180;
  const double a = chroma * std::cos(radians);
  const double b = chroma * std::sin(radians);
  const double l = cubed(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cubed(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cubed(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return Colour(gammaEncoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                gammaEncoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                gammaEncoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

}  // namespace platon
