#include "shared/physics/region.h"

#include <algorithm>

#include "shared/exact/integer.h"

namespace platon {
namespace {

// Lines lie within the coordinates, so that a region need not reach beyond them.
std::int32_t clamped(std::int64_t coordinate) {
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(coordinate, -kCoordinateLimit, kCoordinateLimit));
}

// Half the box's own size on every side: a mover at constant speed then queries the grid every few steps.
Box widened(const Box& box) {
  const std::int64_t marginX = (std::int64_t{box.high.x} - box.low.x) / 2;
  const std::int64_t marginY = (std::int64_t{box.high.y} - box.low.y) / 2;
  return {{clamped(box.low.x - marginX), clamped(box.low.y - marginY)},
          {clamped(box.high.x + marginX), clamped(box.high.y + marginY)}};
}

}  // namespace

void Region::cover(const MapGeometry& part, const Box& box) {
  const Box needed{{clamped(box.low.x), clamped(box.low.y)}, {clamped(box.high.x), clamped(box.high.y)}};
  if (part_ == &part && covered_.contains(needed)) return;
  part_ = &part;
  covered_ = widened(box);
  lines_.clear();
  part.grid.query(covered_, lines_);
}

}  // namespace platon
