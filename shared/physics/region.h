#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/obstacle.h"
#include "platon/physics/segment.h"

namespace platon {

/// The small subset of a map part's lines round one instance, as in the report. Derived: it only saves grid queries,
/// and no result depends on it. A query of the grid before each leg instead makes the steps of 64 movers among 100 or
/// 10 000 lines take more than half as long again.
class Region {
 public:
  /// Makes sure that every line that may meet `box` is in the region. The region reaches some way beyond the box, so
  /// that a mover stays inside for several steps.
  void cover(const MapGeometry& part, const Box& box) {
    if (part_ != &part || !covered_.contains(box)) take(part, box);
  }
  bool isOf(const MapGeometry& part) const { return part_ == &part; }

  /// Indices into the part's lines, ascending.
  const std::vector<std::uint32_t>& lines() const { return lines_; }
  /// The place among them of the first line of a warp; their number when there is none.
  std::size_t firstWarp() const { return firstWarp_; }
  /// The place of a line among them; none when it is far away.
  std::optional<std::size_t> placeOf(std::uint32_t line) const;
  /// Of the line at this place among them.
  const Box& bounds(std::size_t place) const { return bounds_[place]; }
  /// What the line at this place is to `shape`, which must live as long as the region is asked.
  Obstacle& obstacle(std::size_t place, const Convex& shape) {
    if (known_[place] == kUnknown) know(place);
    Obstacle& obstacle = obstacles_[known_[place]];
    if (!obstacle.isOf(shape)) obstacle.become(shape, part_->segments[lines_[place]]);
    return obstacle;
  }

 private:
  static constexpr std::uint32_t kUnknown = ~std::uint32_t{0};

  void take(const MapGeometry& part, const Box& box);
  void keepKnown();
  void know(std::size_t place);

  const MapGeometry* part_ = nullptr;
  Box covered_;
  std::vector<std::uint32_t> lines_;
  std::size_t firstWarp_ = 0;
  std::vector<Box> bounds_;           // by place
  std::vector<std::uint32_t> known_;  // by place, the index of its obstacle: only of lines that have been asked for
  std::vector<Obstacle> obstacles_;
  std::vector<std::uint32_t> spare_;        // obstacles of lines that have been left, for their memory
  std::vector<std::uint32_t> linesBefore_;  // room for work
  std::vector<std::uint32_t> knownBefore_;
};

}  // namespace platon
