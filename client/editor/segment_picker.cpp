#include "client/editor/segment_picker.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

// Part of the way from `a` to `b` that is nearest to the place, 0 … 1.
double partOf(const EditedSegment& segment, glm::dvec2 place) {
  const glm::dvec2 way = segment.b - segment.a;
  const double square = glm::dot(way, way);
  return square > 0 ? std::clamp(glm::dot(place - segment.a, way) / square, 0.0, 1.0) : 0;
}

}  // namespace

std::optional<PickedSegment> pickSegment(std::span<const EditedSegment> segments, const FacePlace& pointer,
                                         double reach) {
  std::optional<PickedSegment> best;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const EditedSegment& segment = segments[i];
    if (segment.face != pointer.face) continue;
    const double part = partOf(segment, pointer.place);
    const double distance = glm::distance(glm::mix(segment.a, segment.b, part), pointer.place);
    if (distance > reach) continue;
    reach = distance;
    best = PickedSegment{i, PickedSegment::Part::kWhole};
  }
  if (!best) return best;
  const EditedSegment& segment = segments[best->segment];
  const double part = partOf(segment, pointer.place);
  if (part < 1.0 / 3) best->part = PickedSegment::Part::kFirstEnd;
  if (part > 2.0 / 3) best->part = PickedSegment::Part::kSecondEnd;
  return best;
}

}  // namespace platon
