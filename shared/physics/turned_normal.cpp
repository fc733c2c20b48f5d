#include "shared/physics/turned_normal.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Bits of the larger coordinate of a rotated normal.
constexpr int kNormalBits = 29;

// `value` / 2^bits rounded away from zero. |value| < 2^62.
std::int64_t shiftAwayFromZero(int bits, std::int64_t value) {
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  return value >= 0 ? (value + most) >> bits : -((most - value) >> bits);
}

}  // namespace

Point turnedNormal(Point normal, Rotation rotation) {
  const WideVector turned = rotateWide(normal, rotation);
  const auto longer = static_cast<std::uint64_t>(std::max(std::abs(turned.x), std::abs(turned.y)));
  int bits = std::max(static_cast<int>(std::bit_width(longer)) - kNormalBits, 0);
  if (shiftAwayFromZero(bits, static_cast<std::int64_t>(longer)) == std::int64_t{1} << kNormalBits) ++bits;
  return {static_cast<std::int32_t>(shiftAwayFromZero(bits, turned.x)),
          static_cast<std::int32_t>(shiftAwayFromZero(bits, turned.y))};
}

}  // namespace platon
