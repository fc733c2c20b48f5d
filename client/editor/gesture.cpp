#include "client/editor/gesture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace platon {

using Part = PickedSegment::Part;

Gesture::Gesture(const SolidMesh& mesh, const FacePlace& from, const SegmentWord& word)
    : mesh_(&mesh),
      first_{from.face, from.place, from.place, word},
      now_(first_),
      grabbed_(from.place),
      plane_(mesh, from.face) {}

Gesture::Gesture(const SolidMesh& mesh, const EditedSegment& segment, const PickedSegment& picked, glm::dvec2 grabbed)
    : mesh_(&mesh),
      first_(segment),
      now_(segment),
      part_(picked.part),
      moved_(picked.segment),
      grabbed_(grabbed),
      plane_(mesh, segment.face) {}

void Gesture::follow(const FacePlace& pointer, std::span<const EditedSegment> segments, const SnapOptions& options,
                     bool straight) {
  // A click moves nothing.
  if (moved_ && !moves_ && glm::distance(plane_.follow(pointer), grabbed_) <= options.reach / 2) return;
  moves_ = true;
  if (part_ == Part::kWhole) {
    // Whole steps of the grid, so that the segment keeps its form.
    glm::dvec2 way = plane_.follow(pointer) - grabbed_;
    if (straight) way = straightened(*mesh_, {0, 0}, way, options);
    if (!straight && !options.free)
      way = {std::round(way.x / options.grid) * options.grid, std::round(way.y / options.grid) * options.grid};
    now_.a = first_.a + way;
    now_.b = first_.b + way;
    return;
  }
  const glm::dvec2 fixed = part_ == Part::kFirstEnd ? first_.b : first_.a;
  const FacePlace near{pointer.face, snapped(*mesh_, segments, pointer, options)};
  const glm::dvec2 place = plane_.follow(straight ? pointer : near);
  (part_ == Part::kFirstEnd ? now_.a : now_.b) = straight ? straightened(*mesh_, fixed, place, options) : place;
}

// A segment that is written beyond the edge stays on its face, where it is cut.
std::vector<EditedSegment> Gesture::pieces() const {
  if (now_ == first_ && moved_) return {first_};
  if (now_.a == now_.b) return {};
  const bool isWhole = part_ == Part::kWhole;
  const bool isCut = !isOnFace(part_ == Part::kFirstEnd ? first_.b : first_.a) || (isWhole && !isOnFace(first_.b));
  if (isCut) return {now_};
  if (part_ != Part::kFirstEnd) return splitOverEdges(*mesh_, onFaceOfFirstEnd(*mesh_, now_));
  EditedSegment turned = now_;
  std::swap(turned.a, turned.b);
  std::vector<EditedSegment> pieces = splitOverEdges(*mesh_, turned);
  for (EditedSegment& piece : pieces) std::swap(piece.a, piece.b);
  return pieces;
}

bool Gesture::isOnFace(glm::dvec2 place) const {
  constexpr double kOneSubunit = 0.001;
  return std::all_of(mesh_->edgeNormals().begin(), mesh_->edgeNormals().end(),
                     [&](glm::dvec2 normal) { return glm::dot(normal, place) <= mesh_->apothem() + kOneSubunit; });
}

}  // namespace platon
