#include "levels/reach/upright_faces.h"

namespace platon {

UprightFaces::UprightFaces(const Level& level) {
  const PlatonicSolid& solid = PlatonicSolid::of(level.solid);
  const std::vector<Point> polygon = facePolygon(level.solid, level.faceSize);
  const auto edges = static_cast<std::size_t>(solid.edgesPerFace());
  add(level.startFace, level.startAngle, polygon);
  for (std::uint32_t node = 0; node < all_.size(); ++node) {
    for (std::size_t edge = 0; edge < edges; ++edge) {
      const auto& behind = solid.neighbour(static_cast<int>(all_[node].face), static_cast<int>(edge));
      const Angle up = all_[node].up + behind.turn;
      std::uint32_t next = find(behind.face, up);
      if (next == all_.size()) next = add(behind.face, up, polygon);
      // Corner i of the edge is corner j + 1 of the neighbour's edge j.
      const Vec there = all_[next].polygon[(behind.edge + 1U) % edges];
      all_[node].neighbours.push_back({next, there - all_[node].polygon[edge]});
    }
  }
}

std::uint32_t UprightFaces::find(std::uint32_t face, Angle up) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const UprightFace& known) { return known.face == face && known.up == up; });
  return static_cast<std::uint32_t>(found - all_.begin());
}

std::uint32_t UprightFaces::add(std::uint32_t face, Angle up, const std::vector<Point>& polygon) {
  UprightFace upright{face, up, {}, {}};
  for (const Point corner : polygon) upright.polygon.push_back(uprightOf(corner, up));
  all_.push_back(std::move(upright));
  return static_cast<std::uint32_t>(all_.size() - 1);
}

}  // namespace platon
