#include "platon/physics/grid.h"

#include <algorithm>
#include <iterator>

#include "shared/exact/square_root.h"
#include "shared/physics/grid_cells.h"

namespace platon {
namespace {

// More references per segment use memory without saving time. Measured on random, long and clustered segments.
constexpr std::size_t kMaxReferencesPerSegment = 6;

// Inner borders that divide the coordinates into `cells` slices of about equal counts.
std::vector<std::int32_t> chooseBorders(std::vector<std::int32_t> coordinates, std::size_t cells) {
  std::sort(coordinates.begin(), coordinates.end());
  std::vector<std::int32_t> borders;
  // i is 64 bits wide so that the product does not overflow a 32-bit std::size_t.
  for (std::uint64_t i = 1; i < cells; ++i) {
    borders.push_back(coordinates[static_cast<std::size_t>(i * coordinates.size() / cells)]);
  }
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

// Number of borders that are at most `coordinate`, of which `known` are. Those of a box are few.
std::size_t bordersUpTo(const std::vector<std::int32_t>& borders, std::int64_t coordinate, std::size_t known) {
  while (known < borders.size() && borders[known] <= coordinate) ++known;
  return known;
}

}  // namespace

Grid::Grid(std::span<const Segment> segments) {
  auto cells = static_cast<std::size_t>(std::max<std::uint64_t>(1, squareRootFloor<std::uint64_t>(segments.size())));
  while (!build(segments, cells, kMaxReferencesPerSegment * segments.size()) && cells > 1) cells /= 2;
}

// Visits the cells of all points of the segment. A point on a border belongs to the lower cell only; queries include
// the cells on both sides of a border that they touch.
template <class Visit>
void Grid::forEachCell(const Segment& segment, Visit&& visit) const {
  const bool upwards = segment.a.y <= segment.b.y;
  const Point a = upwards ? segment.a : segment.b;
  const Point b = upwards ? segment.b : segment.a;
  const std::size_t stride = columns_.size() + 1;
  const std::size_t lastRow = bordersBelow(rows_, b.y);
  for (std::size_t row = bordersBelow(rows_, a.y); row <= lastRow; ++row) {
    const std::int64_t low = row == 0 ? a.y : std::max(a.y, rows_[row - 1]);
    const std::int64_t high = row == rows_.size() ? b.y : std::min(b.y, rows_[row]);
    const CoordinateRange run = xRange(a, b, low, high);
    const std::size_t last = bordersBelow(columns_, run.high);
    for (std::size_t column = bordersBelow(columns_, run.low); column <= last; ++column) visit(row * stride + column);
  }
}

bool Grid::build(std::span<const Segment> segments, std::size_t cellsPerAxis, std::size_t maxReferences) {
  std::vector<std::int32_t> xs;
  std::vector<std::int32_t> ys;
  for (const Segment& segment : segments) {
    xs.insert(xs.end(), {segment.a.x, segment.b.x});
    ys.insert(ys.end(), {segment.a.y, segment.b.y});
  }
  columns_ = chooseBorders(std::move(xs), cellsPerAxis);
  rows_ = chooseBorders(std::move(ys), cellsPerAxis);
  firsts_.assign((columns_.size() + 1) * (rows_.size() + 1) + 1, 0);
  std::size_t references = 0;
  for (const Segment& segment : segments) {
    forEachCell(segment, [&](std::size_t cell) { ++firsts_[cell + 1], ++references; });
    if (references > maxReferences && cellsPerAxis > 1) return false;
  }
  for (std::size_t i = 1; i < firsts_.size(); ++i) firsts_[i] += firsts_[i - 1];
  references_.resize(firsts_.back());
  std::vector<std::uint32_t> next(firsts_.begin(), firsts_.end() - 1);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    forEachCell(segments[i], [&](std::size_t cell) { references_[next[cell]++] = i; });
  }
  return true;
}

Grid::CellRange Grid::cellsOf(const Box& box) const {
  const std::size_t column = bordersBelow(columns_, box.low.x);
  const std::size_t row = bordersBelow(rows_, box.low.y);
  return {column, bordersUpTo(columns_, box.high.x, column), row, bordersUpTo(rows_, box.high.y, row)};
}

template <class Append>
void Grid::query(const Box& box, std::vector<std::uint32_t>& out, Append&& append) const {
  if (references_.empty()) return;
  const std::size_t first = out.size();
  const CellRange cells = cellsOf(box);
  const std::size_t stride = columns_.size() + 1;
  for (std::size_t row = cells.firstRow; row <= cells.lastRow; ++row) {
    const std::uint32_t* begin = references_.data() + firsts_[row * stride + cells.firstColumn];
    const std::uint32_t* end = references_.data() + firsts_[row * stride + cells.lastColumn + 1];
    append(begin, end);
  }
  const auto start = out.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(start, out.end());
  out.erase(std::unique(start, out.end()), out.end());
}

void Grid::query(const Box& box, std::vector<std::uint32_t>& out) const {
  query(box, out, [&out](const auto* begin, const auto* end) { out.insert(out.end(), begin, end); });
}

void Grid::query(const Box& box, std::span<const Segment> segments, std::vector<std::uint32_t>& out) const {
  query(box, out, [&](const auto* begin, const auto* end) {
    std::copy_if(begin, end, std::back_inserter(out), [&](std::uint32_t i) { return touches(segments[i], box); });
  });
}

std::size_t Grid::bytes() const {
  return sizeof(*this) + (columns_.size() + rows_.size()) * sizeof(std::int32_t) +
         (firsts_.size() + references_.size()) * sizeof(std::uint32_t);
}

}  // namespace platon
