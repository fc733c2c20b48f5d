#include "platon/physics/unfold.h"

namespace platon {

namespace {

std::int64_t squaredDistance(PrecisePoint a, PrecisePoint b) { return squaredLength(rounded(a - b)); }

std::optional<PrecisePoint> unfoldPrecise(const Geometry& geometry, const Place& place, std::uint32_t part,
                                          PrecisePoint near, int maxWarps) {
  if (place.part == part) return precise(place.position);
  const MapGeometry* const here = geometry.find(part);
  if (here == nullptr || maxWarps == 0) return std::nullopt;
  std::optional<PrecisePoint> best;
  for (const Warp& warp : here->warps) {
    const auto beyond = unfoldPrecise(geometry, place, warp.target, warp.map(near), maxWarps - 1);
    if (!beyond) continue;
    const PrecisePoint candidate = warp.mapBack(*beyond);
    if (!best || squaredDistance(candidate, near) < squaredDistance(*best, near)) best = candidate;
  }
  return best;
}

}  // namespace

std::optional<Point> unfold(const Geometry& geometry, const Place& place, std::uint32_t part, Point near,
                            int maxWarps) {
  const auto position = unfoldPrecise(geometry, place, part, precise(near), maxWarps);
  return position ? std::optional(rounded(*position)) : std::nullopt;
}

}  // namespace platon
