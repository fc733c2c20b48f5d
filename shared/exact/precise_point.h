#pragma once

#include <cstdint>

#include "shared/exact/point.h"

namespace platon {

/// A position in 65 536ths of a subunit, for what has to be known better than it can be placed.
struct PrecisePoint {
  static constexpr int kBits = 16;
  static constexpr std::int64_t kOne = std::int64_t{1} << kBits;

  std::int64_t x = 0;
  std::int64_t y = 0;

  friend constexpr bool operator==(const PrecisePoint&, const PrecisePoint&) = default;
};

constexpr PrecisePoint precise(Point point) { return {point.x * PrecisePoint::kOne, point.y * PrecisePoint::kOne}; }

/// Half way between two points, exactly.
constexpr PrecisePoint middle(Point a, Point b) {
  return {(std::int64_t{a.x} + b.x) * (PrecisePoint::kOne / 2), (std::int64_t{a.y} + b.y) * (PrecisePoint::kOne / 2)};
}

}  // namespace platon
