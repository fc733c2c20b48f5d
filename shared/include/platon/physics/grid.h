#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platon/physics/segment.h"

namespace platon {

/// An irregular grid: a spatial index of segments. Cell borders are projections of the segments' end points on the two
/// axes. Only every k-th projection becomes a border, so that the numbers of cells and references are linear in the
/// number of segments.
class Grid {
 public:
  Grid() = default;
  explicit Grid(std::span<const Segment> segments);

  /// Appends the indices of all segments that touch `box`, each once, in ascending order. May include segments that
  /// only share a cell with `box`.
  void query(const Box& box, std::vector<std::uint32_t>& out) const;
  /// As above, without those that only share a cell. `segments`: those of the grid.
  void query(const Box& box, std::span<const Segment> segments, std::vector<std::uint32_t>& out) const;

  /// Memory used by the grid in bytes, without the segments.
  std::size_t bytes() const;

 private:
  friend class GridWalk;

  struct CellRange {
    std::size_t firstColumn, lastColumn, firstRow, lastRow;
  };

  bool build(std::span<const Segment> segments, std::size_t cellsPerAxis, std::size_t maxReferences);
  CellRange cellsOf(const Box& box) const;
  template <class Visit>
  void forEachCell(const Segment& segment, Visit&& visit) const;
  template <class Append>
  void query(const Box& box, std::vector<std::uint32_t>& out, Append&& append) const;

  std::vector<std::int32_t> columns_;  // inner borders, ascending: column i is [columns_[i - 1], columns_[i]]
  std::vector<std::int32_t> rows_;
  std::vector<std::uint32_t> firsts_;      // per cell, row by row: index of its first reference; plus one end index
  std::vector<std::uint32_t> references_;  // segment indices, ascending within a cell
};

}  // namespace platon
