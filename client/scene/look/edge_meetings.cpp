#include "client/scene/look/edge_meetings.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

constexpr double kNear = 6;  // walls meet if their places on the edge are at most this far apart

}  // namespace

EdgeMeetings::EdgeMeetings(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces)
    : solid_(solid), meetings_(static_cast<std::size_t>(solid.faces()) * solid.edgeNormals().size()) {
  const int edges = solid.solid().edgesPerFace();
  for (std::size_t face = 0; face < wallsOfFaces.size(); ++face) {
    for (const Wall& wall : wallsOfFaces[face]) {
      for (int edge = 0; edge < edges; ++edge) add(wall, static_cast<int>(face), edge);
    }
  }
  for (std::vector<Interval>& meetings : meetings_) {
    std::sort(meetings.begin(), meetings.end());
    std::vector<Interval> disjoint;
    for (const Interval& meeting : meetings) {
      if (disjoint.empty() || meeting.first > disjoint.back().second) {
        disjoint.push_back(meeting);
      } else {
        disjoint.back().second = std::max(disjoint.back().second, meeting.second);
      }
    }
    meetings = std::move(disjoint);
  }
}

std::size_t EdgeMeetings::indexOf(int face, int edge) const {
  return static_cast<std::size_t>(face) * solid_.edgeNormals().size() + static_cast<std::size_t>(edge);
}

// The part of the edge that a wall covers which reaches it.
EdgeMeetings::Interval EdgeMeetings::meetingOf(const Wall& wall, int edge) const {
  const glm::dvec2 normal = solid_.edgeNormals()[static_cast<std::size_t>(edge)];
  const glm::dvec2 along(-normal.y, normal.x);
  const double a = glm::dot(normal, wall.a) - solid_.apothem();
  const double b = glm::dot(normal, wall.b) - solid_.apothem();
  const auto placeAt = [&](double share) { return glm::dot(along, glm::mix(wall.a, wall.b, share)); };
  if (std::max(std::abs(a), std::abs(b)) <= kStub) return std::minmax({placeAt(0), placeAt(1)});
  const double place = placeAt(std::clamp(a / (a - b), 0.0, 1.0));
  return {place, place};
}

void EdgeMeetings::add(const Wall& wall, int face, int edge) {
  const glm::dvec2 normal = solid_.edgeNormals()[static_cast<std::size_t>(edge)];
  const auto [low, high] = std::minmax({glm::dot(normal, wall.a), glm::dot(normal, wall.b)});
  if (high < solid_.apothem() - wall.halfWidth) return;
  const bool liesAlong = low > solid_.apothem() - kStub && high < solid_.apothem() + kStub;
  if (low > solid_.apothem() - kStub && !liesAlong) return;
  const Interval meeting = meetingOf(wall, edge);
  at(face, edge).emplace_back(meeting.first - kNear, meeting.second + kNear);
}

bool EdgeMeetings::goesOn(const Wall& wall, int face, int edge) const {
  const PlatonicSolid::Neighbour& next = solid_.solid().neighbour(face, edge);
  const std::vector<Interval>& meetings = meetings_[indexOf(next.face, next.edge)];
  const Interval here = meetingOf(wall, edge);
  // The edge runs the other way there.
  const auto after = std::partition_point(meetings.begin(), meetings.end(),
                                          [&](const Interval& meeting) { return meeting.second < -here.second; });
  return after != meetings.end() && after->first <= -here.first;
}

}  // namespace platon
