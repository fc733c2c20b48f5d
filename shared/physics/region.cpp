#include "shared/physics/region.h"

#include <algorithm>
#include <limits>

#include "platon/exact/integer.h"

namespace platon {
namespace {

// Lines lie within the coordinates, so that a region need not reach beyond them.
std::int32_t clamped(std::int64_t coordinate) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(coordinate, -kCoordinateLimit, kCoordinateLimit));
}

Box clamped(const Box& box) {
  return {{clamped(box.low.x), clamped(box.low.y)}, {clamped(box.high.x), clamped(box.high.y)}};
}

// Half the box's own size on every side: a mover at constant speed then queries the grid every few steps.
Box widened(const Box& box) {
  const std::int64_t marginX = (std::int64_t{box.high.x} - box.low.x) / 2;
  const std::int64_t marginY = (std::int64_t{box.high.y} - box.low.y) / 2;
  return {{clamped(box.low.x - marginX), clamped(box.low.y - marginY)},
          {clamped(box.high.x + marginX), clamped(box.high.y + marginY)}};
}

// All beyond the coordinates is covered where there is nothing more to come.
Box unbounded(Box box) {
  using Limits = std::numeric_limits<std::int32_t>;
  if (box.low.x == -kCoordinateLimit) box.low.x = Limits::min();
  if (box.low.y == -kCoordinateLimit) box.low.y = Limits::min();
  if (box.high.x == kCoordinateLimit) box.high.x = Limits::max();
  if (box.high.y == kCoordinateLimit) box.high.y = Limits::max();
  return box;
}

}  // namespace

// Of warp lines, all whose bounds reach into the box are taken, though the grid may know that they pass it: a corner of
// a grown shape reaches farther than its bounds.
void Region::take(const MapGeometry& part, const Box& box) {
  const bool isSamePart = part_ == &part;
  part_ = &part;
  const Box wide = widened(clamped(box));
  covered_ = unbounded(wide);
  linesBefore_ = lines_;  // no swap: both keep the room that they have once needed
  lines_.clear();
  part.grid.query(wide, lines_);
  std::erase_if(lines_,
                [&](std::uint32_t line) { return part.isWarp(line) || !wide.overlaps(boundsOf(part.segments[line])); });
  firstWarp_ = lines_.size();
  for (std::uint32_t line = part.segmentOfWarp(0); line < part.segments.size(); ++line) {
    if (wide.overlaps(boundsOf(part.segments[line]))) lines_.push_back(line);
  }
  bounds_.clear();
  for (const std::uint32_t line : lines_) bounds_.push_back(boundsOf(part.segments[line]));
  knownBefore_ = known_;
  known_.assign(lines_.size(), kUnknown);
  if (!isSamePart) linesBefore_.assign(linesBefore_.size(), kUnknown);
  keepKnown();
}

// What a line is to the shape stays the same for as long as it is near.
void Region::keepKnown() {
  auto line = lines_.begin();
  for (std::size_t before = 0; before < linesBefore_.size(); ++before) {
    if (knownBefore_[before] == kUnknown) continue;
    line = std::lower_bound(line, lines_.end(), linesBefore_[before]);
    if (line != lines_.end() && *line == linesBefore_[before]) {
      known_[static_cast<std::size_t>(line - lines_.begin())] = knownBefore_[before];
    } else {
      spare_.push_back(knownBefore_[before]);
    }
  }
}

void Region::know(std::size_t place) {
  if (spare_.empty()) {
    known_[place] = static_cast<std::uint32_t>(obstacles_.size());
    obstacles_.emplace_back();
    return;
  }
  known_[place] = spare_.back();
  spare_.pop_back();
  obstacles_[known_[place]].forget();
}

std::optional<std::size_t> Region::placeOf(std::uint32_t line) const {
  const auto found = std::lower_bound(lines_.begin(), lines_.end(), line);
  if (found == lines_.end() || *found != line) return std::nullopt;
  return static_cast<std::size_t>(found - lines_.begin());
}

}  // namespace platon
