#include "tests/exactness/oracle/trace/face_checks.h"

#include <algorithm>
#include <cmath>

namespace platon::oracle {
namespace {

constexpr long double kUnit = 1024;
constexpr long double kRounding = 1;
constexpr long double kSmallestSize = 200 * kUnit;
constexpr long double kLargestSize = 65536 * kUnit;
/// Largest distance from a corner to the ends of a post that blocks it.
constexpr long double kPostReach = 64;

/// Distance of `point` from the line through a and b, positive on the left.
long double leftOf(const Segment& line, Vec point) {
  return static_cast<long double>(cross(line.b - line.a, point - line.a)) / distance(toReal(line.a), toReal(line.b));
}

}  // namespace

Segment FaceChecks::edgeOf(std::size_t face, std::size_t edge) const {
  const Polygon& polygon = header_.faces[face].polygon;
  return {polygon[edge % polygon.size()], polygon[(edge + 1) % polygon.size()]};
}

bool FaceChecks::isRegular(const Polygon& polygon) const {
  if (polygon.size() != solid_.corners) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (distance(toReal(polygon[i]), idealCorner(solid_.corners, size_, i)) > kRounding) return false;
  return true;
}

bool FaceChecks::areFacesRegular() {
  const Polygon& first = header_.faces.front().polygon;
  if (first.size() != solid_.corners) {
    failAt(0, std::to_string(first.size()) + " corners");
    return false;
  }
  size_ = kUnit * std::round(distance(toReal(first[0]), toReal(first[1])) / kUnit);
  if (size_ < kSmallestSize || size_ > kLargestSize) {
    fail("face size of " + std::to_string(static_cast<std::int64_t>(size_ / kUnit)));
    return false;
  }
  const auto wrong = std::find_if(header_.faces.begin(), header_.faces.end(),
                                  [&](const TraceFace& face) { return !isRegular(face.polygon); });
  if (wrong == header_.faces.end()) return true;
  failAt(static_cast<std::size_t>(wrong - header_.faces.begin()), "polygon is not a regular face of this size");
  return false;
}

std::optional<std::size_t> FaceChecks::edgeAt(std::size_t face, const Segment& segment, long double tolerance) const {
  for (std::size_t edge = 0; edge < solid_.corners; ++edge) {
    const Segment candidate = edgeOf(face, edge);
    if (distance(toReal(candidate.a), toReal(segment.a)) <= tolerance &&
        distance(toReal(candidate.b), toReal(segment.b)) <= tolerance)
      return edge;
  }
  return std::nullopt;
}

bool FaceChecks::glue(std::size_t face, std::size_t index) {
  const TraceWarp& warp = header_.faces[face].warps[index];
  const auto faces = static_cast<std::int64_t>(header_.faces.size());
  const std::optional<std::size_t> from = edgeAt(face, warp.from, 0);
  if (!from || warp.to < 0 || warp.to >= faces || warp.to == static_cast<std::int64_t>(face)) return false;
  const auto to = static_cast<std::size_t>(warp.to);
  const std::optional<std::size_t> onto = edgeAt(to, {warp.onto.b, warp.onto.a}, kRounding);
  if (!onto) return false;
  seams_[face][*from] = {to, *onto};
  edges_[face].push_back(*from);
  return true;
}

bool FaceChecks::hasReverse(std::size_t face, std::size_t edge) const {
  const Seam& there = seams_[face][edge];
  const Seam& back = seams_[there.face][there.edge];
  return back.face == face && back.edge == edge;
}

bool FaceChecks::areWarpsGlued() {
  const std::size_t count = header_.faces.size();
  seams_.assign(count, std::vector<Seam>(solid_.corners));
  edges_.assign(count, {});
  for (std::size_t face = 0; face < count; ++face) {
    if (header_.faces[face].warps.size() != solid_.corners) return failAt(face, "not one warp for each edge"), false;
    for (std::size_t warp = 0; warp < solid_.corners; ++warp)
      if (!glue(face, warp)) return failAt(face, "warp " + std::to_string(warp) + " does not join two edges"), false;
    std::vector<std::size_t> edges = edges_[face];
    std::sort(edges.begin(), edges.end());
    if (std::unique(edges.begin(), edges.end()) != edges.end()) return failAt(face, "two warps on one edge"), false;
  }
  for (std::size_t face = 0; face < count; ++face)
    for (std::size_t edge = 0; edge < solid_.corners; ++edge)
      if (!hasReverse(face, edge))
        return failAt(face, "edge " + std::to_string(edge) + ": its warp has no reverse warp"), false;
  return true;
}

std::size_t FaceChecks::facesAroundCorner(std::size_t face, std::size_t corner) const {
  // Crossing the edge that starts at the corner leads to a face in which the reversed edge ends at that corner.
  Seam at{face, corner};
  for (std::size_t count = 1; count <= header_.faces.size(); ++count) {
    const Seam next = seams_[at.face][at.edge];
    at = {next.face, (next.edge + 1) % solid_.corners};
    if (at.face == face && at.edge == corner) return count;
  }
  return 0;
}

std::size_t FaceChecks::connectedFaces() const {
  std::vector<std::size_t> found{0};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Seam& seam : seams_[found[i]])
      if (std::find(found.begin(), found.end(), seam.face) == found.end()) found.push_back(seam.face);
  return found.size();
}

void FaceChecks::checkCornersOfSolid() const {
  for (std::size_t face = 0; face < header_.faces.size(); ++face)
    for (std::size_t corner = 0; corner < solid_.corners; ++corner)
      if (facesAroundCorner(face, corner) != solid_.facesPerCorner)
        failAt(face, "not " + std::to_string(solid_.facesPerCorner) + " faces around corner " + std::to_string(corner));
  if (connectedFaces() != header_.faces.size()) fail("the faces are not connected");
}

bool FaceChecks::isInside(std::size_t face, Vec point) const {
  for (std::size_t edge = 0; edge < solid_.corners; ++edge)
    if (leftOf(edgeOf(face, edge), point) < -kRounding) return false;
  return true;
}

bool FaceChecks::blocks(const Segment& line, std::size_t face, std::size_t corner) const {
  const Vec tip = edgeOf(face, corner).a;
  if (line.a == line.b) return distance(toReal(line.a), toReal(tip)) <= kRounding;
  if (std::max(distance(toReal(line.a), toReal(tip)), distance(toReal(line.b), toReal(tip))) > kPostReach) return false;
  const Segment after = edgeOf(face, corner);
  const Segment before = edgeOf(face, corner + solid_.corners - 1);
  const auto joins = [&](Vec a, Vec b) {
    return std::abs(leftOf(before, a)) <= kRounding && std::abs(leftOf(after, b)) <= kRounding;
  };
  return joins(line.a, line.b) || joins(line.b, line.a);
}

bool FaceChecks::isBlocked(std::size_t face, std::size_t corner) const {
  const std::vector<Segment>& lines = header_.faces[face].lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (blocks(lines[i], face, corner) && !isElement(face, i)) return true;
  return false;
}

bool FaceChecks::isElement(std::size_t face, std::size_t line) const {
  return std::any_of(header_.elements.begin(), header_.elements.end(), [&](const TraceElement& element) {
    return element.face == static_cast<std::int64_t>(face) && element.line == static_cast<std::int64_t>(line);
  });
}

void FaceChecks::checkLines() const {
  for (std::size_t face = 0; face < header_.faces.size(); ++face) {
    const std::vector<Segment>& lines = header_.faces[face].lines;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!isInside(face, lines[i].a) || !isInside(face, lines[i].b))
        failAt(face, "line " + std::to_string(i) + " leaves the face");
    for (std::size_t corner = 0; corner < solid_.corners; ++corner)
      if (!isBlocked(face, corner)) failAt(face, "corner " + std::to_string(corner) + " is not blocked");
  }
}

std::size_t FaceChecks::reverseOf(std::size_t face, std::size_t warp) const {
  const Seam& there = seams_[face][edges_[face][warp]];
  const std::vector<std::size_t>& edges = edges_[there.face];
  return static_cast<std::size_t>(std::find(edges.begin(), edges.end(), there.edge) - edges.begin());
}

Isometry FaceChecks::motionOf(std::size_t face, std::size_t warp) const {
  const std::size_t from = edges_[face][warp];
  const Seam& there = seams_[face][from];
  const auto edgeTurn = kTurn / static_cast<std::int64_t>(solid_.corners);
  const std::int64_t turn =
      kTurn / 2 + edgeTurn * (static_cast<std::int64_t>(there.edge) - static_cast<std::int64_t>(from));
  return Isometry(turn, idealEdgeMiddle(solid_.corners, size_, from),
                  idealEdgeMiddle(solid_.corners, size_, there.edge));
}

}  // namespace platon::oracle
