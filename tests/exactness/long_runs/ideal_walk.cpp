#include "tests/exactness/long_runs/ideal_walk.h"

#include "platon/exact/integer.h"
#include "tests/exactness/step_check/conversions.h"

namespace platon::long_runs {

IdealWalk::IdealWalk(SolidKind kind, std::int32_t faceSize, std::uint32_t face, Point start)
    : solid_(PlatonicSolid::of(kind)),
      edgeLength_(static_cast<long double>(faceSize) * kSubunitsPerUnit),
      face_(face),
      place_(oracle::toReal(step_check::toVec(start))) {}

oracle::RealVec IdealWalk::turned(Point vector) const {
  return oracle::Isometry(heading_.centidegrees(), {}, {}).apply(oracle::toReal(step_check::toVec(vector)));
}

void IdealWalk::leg(std::uint32_t, std::span<const InstanceView> instances) {
  for (const InstanceView& view : instances) {
    if (view.home && view.part != face_) cross(view.part);
  }
}

void IdealWalk::cross(std::uint32_t face) {
  const auto from = static_cast<int>(face_);
  const auto corners = static_cast<std::size_t>(solid_.edgesPerFace());
  for (int edge = 0; edge < solid_.edgesPerFace(); ++edge) {
    const PlatonicSolid::Neighbour& behind = solid_.neighbour(from, edge);
    if (behind.face != face) continue;
    const oracle::Isometry over(behind.turn.centidegrees(),
                                oracle::idealEdgeMiddle(corners, edgeLength_, static_cast<std::size_t>(edge)),
                                oracle::idealEdgeMiddle(corners, edgeLength_, behind.edge));
    place_ = over.apply(place_);
    heading_ = heading_ + behind.turn;
    face_ = face;
    ++crossings_;
    return;
  }
}

}  // namespace platon::long_runs
