#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platon/physics/segment.h"

namespace platon {

/// The irregular grid of the report over the lines of a map part: cell borders are projections of the lines' end
/// points on both axes. Of the n projections per axis only every k-th becomes a border, so that cells and references
/// stay linear in the number of lines.
class Grid {
 public:
  Grid() = default;
  explicit Grid(std::span<const Segment> lines);

  /// Appends the index of every line that may meet `box`, each once and in ascending order. A superset: lines that
  /// only share a cell with the box are among them.
  void query(const Box& box, std::vector<std::uint32_t>& out) const;

  /// Bytes held by the grid, without the lines themselves.
  std::size_t bytes() const;

 private:
  struct CellRange {
    std::size_t firstColumn, lastColumn, firstRow, lastRow;
  };

  bool build(std::span<const Segment> lines, std::size_t cellsPerAxis, std::size_t mostReferences);
  CellRange cellsOf(const Box& box) const;
  template <class Visit>
  void forEachCell(const Segment& line, Visit&& visit) const;

  std::vector<std::int32_t> columns_;  // inner borders, ascending: column i is [columns_[i - 1], columns_[i]]
  std::vector<std::int32_t> rows_;
  std::vector<std::uint32_t> firsts_;      // per cell, row by row, the first of its references; one more at the end
  std::vector<std::uint32_t> references_;  // line indices, ascending within a cell
};

}  // namespace platon
