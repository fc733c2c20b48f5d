#include "platon/physics/unfold.h"

namespace platon {

namespace {

Point broughtBack(const Warp& warp, Point beyond) { return warp.from.a + rotate(beyond - warp.onto.a, -warp.turn); }

Point takenOver(const Warp& warp, Point here) { return warp.onto.a + rotate(here - warp.from.a, warp.turn); }

void keepNearer(std::optional<Point>& best, std::optional<Point> candidate, Point near) {
  if (!candidate) return;
  if (!best || squaredLength(*candidate - near) < squaredLength(*best - near)) best = candidate;
}

}  // namespace

std::optional<Point> unfold(const Geometry& geometry, const Place& place, std::uint32_t part, Point near,
                            int maxWarps) {
  if (place.part == part) return place.position;
  const MapGeometry* const here = geometry.find(part);
  if (here == nullptr || maxWarps == 0) return std::nullopt;
  std::optional<Point> best;
  for (const Warp& warp : here->warps) {
    const std::optional<Point> beyond = unfold(geometry, place, warp.target, takenOver(warp, near), maxWarps - 1);
    if (beyond) keepNearer(best, broughtBack(warp, *beyond), near);
  }
  return best;
}

}  // namespace platon
