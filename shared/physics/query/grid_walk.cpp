#include "shared/physics/query/grid_walk.h"

#include <algorithm>
#include <utility>

#include "shared/physics/grid_cells.h"

namespace platon {

GridWalk::GridWalk(const Grid& grid, const Box& extent, Point from, Point displacement)
    : grid_(grid), extent_(extent), from_(from), displacement_(displacement) {
  if (grid.references_.empty()) return;
  const std::int64_t end = std::int64_t{from.y} + displacement.y;
  const std::size_t low = bordersBelow(grid.rows_, std::min<std::int64_t>(from.y, end) + extent.low.y);
  const std::size_t high = bordersBelow(grid.rows_, std::max<std::int64_t>(from.y, end) + extent.high.y);
  row_ = first_ = displacement.y < 0 ? high : low;
  left_ = high - low + 1;
}

Fraction GridWalk::reached() const {
  if (row_ == first_ || displacement_.y == 0) return {0, 1};
  const bool up = displacement_.y > 0;
  // The border that the box crosses into this row, and the part of the box that crosses it first.
  const std::int64_t border = up ? grid_.rows_[row_ - 1] : grid_.rows_[row_];
  const std::int64_t front = std::int64_t{from_.y} + (up ? extent_.high.y : extent_.low.y);
  const std::int64_t distance = up ? border - front : front - border;
  return {std::max<std::int64_t>(distance, 0), up ? displacement_.y : -std::int64_t{displacement_.y}};
}

std::span<const std::uint32_t> GridWalk::segments() const {
  Point a = from_;
  Point b = from_ + displacement_;
  if (a.y > b.y) std::swap(a, b);
  // The positions of the box at which it reaches the row.
  const std::int64_t low = row_ == 0 ? a.y : std::int64_t{grid_.rows_[row_ - 1]} - extent_.high.y;
  const std::int64_t high = row_ == grid_.rows_.size() ? b.y : std::int64_t{grid_.rows_[row_]} - extent_.low.y;
  const CoordinateRange run =
      xRange(a, b, std::clamp<std::int64_t>(low, a.y, b.y), std::clamp<std::int64_t>(high, a.y, b.y));
  const std::size_t begin = row_ * (grid_.columns_.size() + 1);
  const std::size_t first = begin + bordersBelow(grid_.columns_, run.low + extent_.low.x);
  const std::size_t last = begin + bordersBelow(grid_.columns_, run.high + extent_.high.x);
  return std::span(grid_.references_).subspan(grid_.firsts_[first], grid_.firsts_[last + 1] - grid_.firsts_[first]);
}

void GridWalk::next() {
  --left_;
  if (left_ != 0) row_ = displacement_.y < 0 ? row_ - 1 : row_ + 1;
}

}  // namespace platon
