#include "client/editor/over_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace platon {
namespace {

constexpr double kBeyond = 0.5;     // level units
constexpr double kShortest = 0.01;  // a shorter piece only touches its face
constexpr double kOnEdge = 1e-6;
constexpr int kMaxFaces = 64;

struct Exit {
  int edge = 0;
  double part = 0;  // of the segment
};

glm::dvec2 mapped(const glm::dmat4& map, glm::dvec2 point) { return glm::dvec2(map * glm::dvec4(point, 0, 1)); }

// Where the way from `a` to `b` leaves the face, if it does.
std::optional<Exit> exitOf(const SolidMesh& mesh, glm::dvec2 a, glm::dvec2 b) {
  std::optional<Exit> first;
  for (std::size_t edge = 0; edge < mesh.edgeNormals().size(); ++edge) {
    const double from = glm::dot(mesh.edgeNormals()[edge], a) - mesh.apothem();
    const double to = glm::dot(mesh.edgeNormals()[edge], b) - mesh.apothem();
    if (to <= kOnEdge || to <= from) continue;
    const double part = std::max(0.0, -from / (to - from));
    if (!first || part < first->part) first = Exit{static_cast<int>(edge), part};
  }
  return first;
}

// The segment as seen from the face behind the edge.
EditedSegment behind(const SolidMesh& mesh, EditedSegment segment, int edge) {
  const PlatonicSolid::Neighbour& next = mesh.solid().neighbour(segment.face, edge);
  const glm::dmat4 map = glm::inverse(mesh.unfolded(segment.face, edge));
  segment.a = mapped(map, segment.a);
  segment.b = mapped(map, segment.b);
  segment.face = next.face;
  if (segment.word.namesEdge()) {
    // Edge numbers grow counter-clockwise, as angles do.
    const int edges = mesh.solid().edgesPerFace();
    const double turned = double{1} * next.turn.centidegrees() * edges / Angle::kTurn;
    int& edgeNamed = segment.word.numbers[0];
    edgeNamed = static_cast<int>(std::lround(edgeNamed + turned + edges)) % edges;
  }
  return segment;
}

double rounded(double value) { return std::round(value * 10000) / 10000; }

// The point as it is written.
glm::dvec2 written(glm::dvec2 point) { return {rounded(point.x), rounded(point.y)}; }

bool isExact(const SolidMesh& mesh, glm::dvec2 point, int edge) {
  const glm::dvec2 normal = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
  return std::abs(glm::dot(normal, written(point)) - mesh.apothem()) < kOnEdge;
}

}  // namespace

std::vector<EditedSegment> splitOverEdges(const SolidMesh& mesh, const EditedSegment& segment) {
  std::vector<EditedSegment> pieces;
  EditedSegment left = segment;  // what is left of it, in the frame of left.face
  double before = 0;             // how far the next piece begins before left.a
  for (int count = 0; count < kMaxFaces; ++count) {
    const double length = glm::distance(left.a, left.b);
    const glm::dvec2 along = length > 0 ? (left.b - left.a) / length : glm::dvec2(0);
    const std::optional<Exit> exit = exitOf(mesh, left.a, left.b);
    EditedSegment piece = left;
    piece.a -= along * before;
    if (!exit) {
      if (length > kShortest || pieces.empty()) pieces.push_back(piece);
      break;
    }
    const glm::dvec2 place = left.a + (left.b - left.a) * exit->part;
    const bool exact = isExact(mesh, place, exit->edge);
    piece.b = exact ? written(place) : place + along * std::min(kBeyond, length * (1 - exit->part));
    if (length * exit->part > kShortest) pieces.push_back(piece);
    left.a = place;
    left = behind(mesh, left, exit->edge);
    const int entry = mesh.solid().neighbour(piece.face, exit->edge).edge;
    before = pieces.empty() || isExact(mesh, left.a, entry) ? 0 : kBeyond;
  }
  return pieces;
}

EditedSegment onFaceOfFirstEnd(const SolidMesh& mesh, const EditedSegment& segment) {
  EditedSegment there = segment;
  glm::dvec2 middle(0);
  for (int count = 0; count < kMaxFaces; ++count) {
    const std::optional<Exit> exit = exitOf(mesh, middle, there.a);
    if (!exit) break;
    const EditedSegment way{there.face, middle + (there.a - middle) * exit->part, there.a, {}};
    middle = behind(mesh, way, exit->edge).a;
    there = behind(mesh, there, exit->edge);
  }
  return there;
}

glm::dvec2 UnfoldedPlane::follow(const FacePlace& pointer) {
  std::vector<std::optional<glm::dmat4>> maps(static_cast<std::size_t>(mesh_->faces()));
  const auto at = [&maps](int face) -> std::optional<glm::dmat4>& { return maps[static_cast<std::size_t>(face)]; };
  at(face_) = toPlane_;
  std::deque<int> open{face_};
  for (; !at(pointer.face); open.pop_front()) {
    for (int edge = 0; edge < mesh_->solid().edgesPerFace(); ++edge) {
      const int next = mesh_->solid().neighbour(open.front(), edge).face;
      if (at(next)) continue;
      at(next) = *at(open.front()) * mesh_->unfolded(open.front(), edge);
      open.push_back(next);
    }
  }
  face_ = pointer.face;
  toPlane_ = *at(face_);
  return mapped(toPlane_, pointer.place);
}

}  // namespace platon
