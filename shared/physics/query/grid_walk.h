#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "platon/exact/fraction.h"
#include "platon/physics/grid.h"
#include "platon/physics/segment.h"

namespace platon {

/// Walks over the cells of a grid that a moving box reaches, one row of cells after the other, in the direction of the
/// motion. So a query can stop at the first row that is later than what it has found. This is the traversal of a grid
/// by a ray (Amanatides and Woo 1987), with rows in place of single cells, because the cells of a row are contiguous.
class GridWalk {
 public:
  /// A box `extent`, relative to a position that moves from `from` along `displacement`. The grid must outlive the
  /// walk.
  GridWalk(const Grid& grid, const Box& extent, Point from, Point displacement);

  /// Whether there is no row left.
  bool isDone() const { return left_ == 0; }
  /// The earliest time at which the box reaches the present row or a later one, as a fraction of the displacement.
  Fraction reached() const;
  /// Indices of all segments in those cells of the present row that the box reaches. One may occur several times.
  std::span<const std::uint32_t> segments() const;
  /// Goes to the next row.
  void next();

 private:
  const Grid& grid_;
  Box extent_;
  Point from_;
  Point displacement_;
  std::size_t row_ = 0;
  std::size_t first_ = 0;  // row
  std::size_t left_ = 0;   // number of rows
};

}  // namespace platon
