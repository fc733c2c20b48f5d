#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"

namespace platon {

/// Normals of contacts, turned and scaled to the length of a unit (PlayerState::kUnit). The same few lines are met tick
/// after tick and a root is dear, so that each is kept until another takes its place. Derived: no result depends on it.
class UnitNormals {
 public:
  /// `normal`, not zero and below 2^30 a coordinate, turned by `turn`.
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

  // The high bits of a product mix all that it was made of.
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
