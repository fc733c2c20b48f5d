#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"

namespace platon {

/// Computes unit normals (length PlayerState::kUnit) of contacts and caches them, because a player touches the same few
/// segments tick after tick and a square root is slow. Derived data: no result depends on the cache.
class UnitNormals {
 public:
  /// Unit vector of `normal` rotated by `turn`. `normal` is not (0, 0); its coordinates are below 2^30.
  Point of(Point normal, Angle turn) {
    Entry& entry = entries_[slotOf(normal, turn)];
    if (entry.normal != normal || entry.turn != turn) entry = {normal, turn, computed(normal, turn)};
    return entry.unit;
  }

 private:
  struct Entry {
    Point normal;  // (0, 0): empty
    Angle turn;
    Point unit;
  };
  static constexpr int kSlotBits = 6;

  // Multiplicative hashing: the high bits of a product depend on all bits of its factors.
  static std::size_t slotOf(Point normal, Angle turn) {
    const auto x = static_cast<std::uint64_t>(normal.x) * 0x9e3779b97f4a7c15U;
    const auto y = static_cast<std::uint64_t>(normal.y) * 0xc2b2ae3d27d4eb4fU;
    const auto z = static_cast<std::uint64_t>(turn.centidegrees()) * 0x165667b19e3779f9U;
    return static_cast<std::size_t>((x + y + z) >> (64 - kSlotBits));
  }
  static Point computed(Point normal, Angle turn);

  std::array<Entry, std::size_t{1} << kSlotBits> entries_;
};

}  // namespace platon
