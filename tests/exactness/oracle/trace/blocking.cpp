#include "tests/exactness/oracle/trace/blocking.h"

#include <algorithm>
#include <map>

#include "tests/exactness/oracle/trace/solid_model.h"

namespace platon::oracle {

void Blocking::setOpen(const std::vector<std::int64_t>& open, std::int64_t tick) {
  std::fill(isOpen_.begin(), isOpen_.end(), false);
  for (const std::int64_t index : open) {
    const bool isElement = index >= 0 && index < static_cast<std::int64_t>(isOpen_.size());
    const bool mayOpen =
        isElement && (map_.element(index).word == Word::kDoor || map_.element(index).word == Word::kTimed);
    if (!mayOpen || isOpen_[static_cast<std::size_t>(index)])
      return report_.violate("open", std::to_string(index) + " cannot open, or is listed twice");
    isOpen_[static_cast<std::size_t>(index)] = true;
  }
  std::map<std::int64_t, bool> byNumber;
  for (std::size_t i = 0; i < isOpen_.size(); ++i) {
    const MapElement& element = map_.elements()[i];
    if (element.word == Word::kDoor && byNumber.emplace(element.number, isOpen_[i]).first->second != isOpen_[i])
      report_.violate("open", "only some of the doors " + std::to_string(element.number) + " are open");
    const bool byClock = element.word == Word::kTimed && tick % (element.number + element.second) >= element.number;
    if (element.word == Word::kTimed && isOpen_[i] != byClock)
      report_.violate("open", "timed segment " + std::to_string(i) + " is not as the clock says");
  }
}

bool Blocking::isOnLeftSide(const Segment& segment, const TraceInstance& instance) {
  const Polygon& shape = shapes_.of(instance).polygon;
  return std::all_of(shape.begin(), shape.end(), [&](Vec vertex) {
    return cross(segment.b - segment.a, instance.position + vertex - segment.a) >= 0;
  });
}

// The up of a player is the +y of its shape. Edge 0 is at the bottom, and the others follow counter-clockwise. A
// direction in the middle between two edges points to the one that is counter-clockwise of it.
bool Blocking::pointsUpTo(std::int64_t edge, const TraceInstance& instance) const {
  const auto edges = static_cast<std::int64_t>(map_.face(instance.face).edges);
  const std::int64_t fromEdge = normalizedAngle(instance.angle - kTurn / 2 - edge * kTurn / edges);
  const std::int64_t half = kTurn / edges / 2;
  return fromEdge < half || fromEdge >= kTurn - half;
}

bool Blocking::overlaps(const MapLine& line, const TraceInstance& instance) {
  return OpenArea::placed(shapes_.of(instance).polygon, instance.position).intersects(line.segment);
}

bool Blocking::forbids(const MapLine& line, const TraceInstance& instance) {
  if (line.element < 0) return true;
  const MapElement& element = map_.element(line.element);
  switch (element.word) {
    case Word::kOneway:
      return isOnLeftSide(line.segment, instance);
    case Word::kUp:
      return pointsUpTo(element.number, instance);
    case Word::kDoor:
    case Word::kTimed:
      return !isOpen_[static_cast<std::size_t>(line.element)];
    case Word::kCheckpoint:
    case Word::kKey:
      return false;
    case Word::kHazard:
    case Word::kPlate:
      return true;
  }
  return true;
}

bool Blocking::blocksAlways(const MapLine& line) const {
  if (line.element < 0) return true;
  switch (map_.element(line.element).word) {
    case Word::kHazard:
    case Word::kPlate:
      return true;
    case Word::kOneway:
    case Word::kUp:
    case Word::kDoor:
    case Word::kTimed:
    case Word::kCheckpoint:
    case Word::kKey:
      return false;
  }
  return false;
}

bool Blocking::blocks(const MapLine& line, const TraceInstance& start) {
  return blocksAlways(line) || (forbids(line, start) && !overlaps(line, start));
}

}  // namespace platon::oracle
