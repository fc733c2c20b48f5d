#pragma once

#include <cstdint>
#include <vector>

#include "shared/physics/map_geometry.h"
#include "shared/physics/segment.h"

namespace platon {

/// The small subset of a map part's lines round one instance, as in the report. Derived: it only saves grid queries,
/// and no result depends on it.
class Region {
 public:
  /// Makes sure that every line that may meet `box` is in the region. The region reaches some way beyond the box, so
  /// that a mover stays inside for several steps.
  void cover(const MapGeometry& part, const Box& box);

  /// Indices into the part's lines, ascending.
  const std::vector<std::uint32_t>& lines() const { return lines_; }

 private:
  const MapGeometry* part_ = nullptr;
  Box covered_;
  std::vector<std::uint32_t> lines_;
};

}  // namespace platon
