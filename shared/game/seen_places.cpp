#include "shared/game/seen_places.h"

#include <algorithm>

namespace platon {
namespace {

// Whether the point is within `distance` of the segment. Bounds: coordinates < 2^28, so that squares are < 2^58.
bool isWithin(Point point, const Segment& segment, std::int64_t distance) {
  const Point along = segment.b - segment.a;
  const Point fromA = point - segment.a;
  const std::int64_t limit = distance * distance;
  if (dot(fromA, along) <= 0) return squaredLength(fromA) <= limit;
  const Point fromB = point - segment.b;
  if (dot(fromB, along) >= 0) return squaredLength(fromB) <= limit;
  const int128 beside = cross(along, fromA);
  return beside * beside <= int128{limit} * squaredLength(along);
}

}  // namespace

std::vector<Place> seenPlaces(const Geometry& geometry, const Place& place, std::int32_t distance) {
  std::vector<Place> places{place};
  for (const Warp& warp : geometry.find(place.part)->warps) {
    if (!isWithin(place.position, warp.from, distance)) continue;
    const PrecisePoint seen = warp.map(precise(place.position));
    places.push_back({warp.target, rounded(seen)});
    for (const Warp& further : geometry.find(warp.target)->warps) {
      if (further.from == warp.onto || further.from == Segment{warp.onto.b, warp.onto.a}) continue;
      if (!isWithin(rounded(seen), further.from, distance)) continue;
      places.push_back({further.target, rounded(further.map(seen))});
    }
  }
  return places;
}

}  // namespace platon
