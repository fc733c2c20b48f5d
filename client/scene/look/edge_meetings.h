#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "client/scene/look/wall.h"
#include "client/scene/solid_mesh.h"

namespace platon {

/// Where walls meet the edges of the faces from inside. Lengths in level units.
class EdgeMeetings {
 public:
  static constexpr double kStub = 4;  ///< a wall that goes no farther into a face only sticks out of the neighbour

  /// `solid` must outlive the object.
  EdgeMeetings(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces);

  /// Whether a wall that ends at `edge` of `face` goes on over it: a wall of the neighbour begins at the same place of
  /// the edge.
  bool goesOn(const Wall& wall, int face, int edge) const;

 private:
  using Interval = std::pair<double, double>;  // along the edge, counter-clockwise

  std::vector<Interval>& at(int face, int edge) { return meetings_[indexOf(face, edge)]; }
  std::size_t indexOf(int face, int edge) const;
  Interval meetingOf(const Wall& wall, int edge) const;
  void add(const Wall& wall, int face, int edge);

  const SolidMesh& solid_;
  std::vector<std::vector<Interval>> meetings_;  // by face and edge; sorted and disjoint
};

}  // namespace platon
