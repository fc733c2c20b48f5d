#include "client/scene/walls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

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

namespace {

constexpr double kWidth = StageModel::kRibbonWidth;
constexpr double kLow = 3;          // height of an open door, level units
constexpr double kLedge = 4;        // height of a oneway
constexpr double kFence = 8;        // height of a hazard
constexpr double kMaxPieces = 256;  // of an element

const Colour kGold(0.95F, 0.72F, 0.28F);
const Colour kRed(1.0F, 0.40F, 0.34F);
const Colour kViolet(0.74F, 0.55F, 0.95F);
const Colour kBlue(0.62F, 0.80F, 0.98F);
const Colour kGreen(0.58F, 0.90F, 0.62F);

// The walls of one element.
class ElementWalls {
 public:
  ElementWalls(const ElementDrawing& drawing, double active, Colour wall, std::vector<Wall>& walls)
      : active_(active),
        wall_(wall),
        walls_(walls),
        from_(drawing.ends.a),
        length_(glm::distance(drawing.ends.a, drawing.ends.b)) {
    along_ = length_ > 0 ? (glm::dvec2(drawing.ends.b) - from_) / length_ : glm::dvec2(1, 0);
  }

  void add(ElementKind kind) {
    switch (kind) {
      case ElementKind::kOneway:
        return addRod({0, 0}, {length_, 0}, kWidth / 3, kLedge, wall_);
      case ElementKind::kUp:
        return addBlocks();
      case ElementKind::kHazard:
        return addZigzag();
      case ElementKind::kDoor:
        return addRails();
      case ElementKind::kPlate:
        return addPlate();
      case ElementKind::kTimed:
        return addPosts();
      case ElementKind::kCheckpoint:
      case ElementKind::kKey:
        return;
    }
  }

 private:
  // `from` and `to`: x along the segment, y to its left.
  void addRod(glm::dvec2 from, glm::dvec2 to, double halfWidth, double height, Colour colour) {
    walls_.push_back({at(from), at(to), halfWidth, height, colour});
  }

  glm::dvec2 at(glm::dvec2 place) const { return from_ + place.x * along_ + place.y * glm::dvec2(-along_.y, along_.x); }

  double pieces(double gap) const { return std::clamp(std::floor(length_ / gap), 1.0, kMaxPieces); }

  // What lets pass is hollow, and no wall.
  void addBlocks() {
    if (active_ <= 0) return;
    const double count = pieces(4 * kWidth);
    const double gap = length_ / count;
    const double half = std::max(0.33 * gap - kWidth / 2, 0.0);
    for (double i = 0.5; i < count; ++i) {
      addRod({i * gap - half, 0}, {i * gap + half, 0}, kWidth / 2, active_ * Wall::kHeight, kBlue);
    }
  }

  void addZigzag() {
    const double count = pieces(2 * kWidth);
    const double gap = length_ / count;
    const double aside = 1.5 * kWidth;
    for (double i = 0; i < count; ++i) {
      const double side = std::fmod(i, 2) == 0 ? aside : -aside;
      addRod({i * gap, -side}, {(i + 1) * gap, side}, 0.45 * kWidth, kFence, kRed);
    }
  }

  void addRails() {
    const double leaf = glm::mix(std::min(2.5 * kWidth, length_ / 2), length_ / 2, active_);
    const double height = glm::mix(kLow, Wall::kHeight, active_);
    for (const double side : {-kWidth, kWidth}) {
      if (active_ >= 1) {
        addRod({0, side}, {length_, side}, 0.4 * kWidth, height, kGold);
      } else {
        addRod({0, side}, {leaf, side}, 0.4 * kWidth, height, kGold);
        addRod({length_ - leaf, side}, {length_, side}, 0.4 * kWidth, height, kGold);
      }
    }
  }

  // A fence of posts that sink into the face while it is open.
  void addPosts() {
    const double count = pieces(2 * kWidth);
    const double gap = length_ / count;
    const double height = glm::mix(kLow, Wall::kHeight, active_);
    for (double i = 0.5; i < count; ++i) {
      const double half = 0.2 * std::min(gap, 2 * kWidth);
      addRod({i * gap - half, 0}, {i * gap + half, 0}, 0.45 * kWidth, height, kGreen);
    }
  }

  void addPlate() {
    const double high = glm::mix(1.6, 0.7, active_) * kWidth;
    const double thick = glm::mix(1.0, 0.55, active_) * kWidth;
    addRod({0, 0}, {length_, 0}, 0.4 * kWidth, Wall::kHeight, wall_);
    const double margin = std::min(0.15 * length_ + high, length_ / 2);
    addRod({margin, high}, {length_ - margin, high}, thick, glm::mix(Wall::kHeight, kFence, active_), kViolet);
  }

  double active_;  // 0 … 1
  Colour wall_;
  std::vector<Wall>& walls_;
  glm::dvec2 from_;
  double length_;
  glm::dvec2 along_{1, 0};
};

}  // namespace

std::vector<std::vector<Wall>> wallsOf(const StageModel& stage) {
  std::vector<std::vector<Wall>> walls;
  for (const FaceDrawing& face : stage.faces) {
    walls.emplace_back();
    for (const Ribbon& ends : face.ribbons)
      walls.back().push_back({ends.a, ends.b, kWidth / 2, Wall::kHeight, stage.scheme().wall});
  }
  return walls;
}

std::vector<std::vector<Wall>> elementWallsOf(const StageModel& stage, std::span<const double> shares) {
  std::vector<std::vector<Wall>> walls;
  for (const FaceDrawing& face : stage.faces) {
    walls.emplace_back();
    for (const ElementDrawing& drawing : face.elements) {
      ElementWalls(drawing, shares[drawing.element], stage.scheme().wall, walls.back()).add(drawing.kind);
    }
  }
  return walls;
}

EdgeMeetings edgeMeetingsOf(const StageModel& stage) {
  std::vector<std::vector<Wall>> walls = wallsOf(stage);
  for (std::size_t face = 0; face < walls.size(); ++face) {
    for (const ElementDrawing& drawing : stage.faces[face].elements) {
      if (!canBlock(drawing.kind)) continue;
      walls[face].push_back({drawing.ends.a, drawing.ends.b});
    }
  }
  return {stage.mesh, walls};
}

namespace {

struct Corner {
  glm::dvec2 place{0};
  glm::dvec2 aside{0};  // from the axis of the wall
};
using Outline = std::vector<Corner>;  // counter-clockwise

constexpr double kOnEdge = 0.01;  // level units: an end this near to an edge reaches it
constexpr double kMinArea = 1e-3;
constexpr std::size_t kFewWalls = 400;
constexpr std::size_t kManyWalls = 4000;

// Into how many parts a round end is divided.
int partsOfAnEnd(std::size_t walls) {
  if (walls <= kFewWalls) return 6;
  return walls <= kManyWalls ? 2 : 1;
}

glm::dvec2 rotated(glm::dvec2 vector, double angle) {
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return {vector.x * cosine - vector.y * sine, vector.x * sine + vector.y * cosine};
}

class WallMeshBuilder {
 public:
  WallMeshBuilder(const SolidMesh& solid, const EdgeMeetings& meetings, int partsOfEnd)
      : solid_(solid), meetings_(meetings), partsOfEnd_(partsOfEnd), lean_(1 / std::tan(solid.dihedral() / 2)) {}

  void beginFace() {
    ++face_;
    mesh_.faces.push_back({mesh_.triangles.size(), 0});
  }
  void endFace() { mesh_.faces.back().count = mesh_.triangles.size() - mesh_.faces.back().first; }

  void add(const Wall& wall) {
    if (onlyTouches(wall)) return;
    findLeans(wall);
    Outline outline = outlineOf(wall);
    for (const glm::dvec2 edge : solid_.edgeNormals()) outline = cut(outline, edge);
    if (areaOf(outline) < kMinArea) return;
    addTop(outline, wall);
    for (std::size_t i = 0; i < outline.size(); ++i)
      addSide(outline[i].place, outline[(i + 1) % outline.size()].place, wall);
  }

  WallMesh take() { return std::move(mesh_); }

 private:
  // Whether a wall of a neighbour ends at the common edge: its round end would stick out of the wall that goes on here.
  bool onlyTouches(const Wall& wall) const {
    return std::any_of(solid_.edgeNormals().begin(), solid_.edgeNormals().end(), [&](glm::dvec2 edge) {
      const double a = glm::dot(edge, wall.a) - solid_.apothem();
      const double b = glm::dot(edge, wall.b) - solid_.apothem();
      return std::min(a, b) > -EdgeMeetings::kStub && std::max(a, b) > wall.halfWidth;
    });
  }

  void findLeans(const Wall& wall) {
    leans_.clear();
    for (int edge = 0; edge < solid_.solid().edgesPerFace(); ++edge) {
      if (meetings_.goesOn(wall, face_, edge)) leans_.push_back(solid_.edgeNormals()[static_cast<std::size_t>(edge)]);
    }
  }

  // An end on an edge is moved beyond it, so that the cut has the full width.
  glm::dvec2 endOf(glm::dvec2 end, glm::dvec2 outwards, double halfWidth) const {
    for (const glm::dvec2 edge : solid_.edgeNormals()) {
      const double slope = glm::dot(edge, outwards);
      const bool reaches = glm::dot(edge, end) > solid_.apothem() - kOnEdge && slope > 0.1;
      if (reaches) return end + outwards * (2 * halfWidth / slope);
    }
    return end;
  }

  Outline outlineOf(const Wall& wall) const {
    const double length = glm::distance(wall.a, wall.b);
    const glm::dvec2 way = length > 0 ? (wall.b - wall.a) / length : glm::dvec2(1, 0);
    Outline outline;
    for (const auto& [middle, outwards] :
         {std::pair(endOf(wall.b, way, wall.halfWidth), way), {endOf(wall.a, -way, wall.halfWidth), -way}}) {
      for (int part = 0; part <= partsOfEnd_; ++part) {
        const double angle = (double{1} * part / partsOfEnd_ - 0.5) * std::numbers::pi;
        const glm::dvec2 aside = wall.halfWidth * rotated(outwards, angle);
        outline.push_back({middle + aside, aside});
      }
    }
    return outline;
  }

  // The part of the outline on the inner side of an edge.
  Outline cut(const Outline& outline, glm::dvec2 edge) const {
    Outline inner;
    const auto beyond = [&](glm::dvec2 point) { return glm::dot(edge, point) - solid_.apothem(); };
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Corner& from = outline[i];
      const Corner& to = outline[(i + 1) % outline.size()];
      const double out = beyond(from.place);
      const double next = beyond(to.place);
      if (out <= 0) inner.push_back(from);
      const double share = out / (out - next);
      if ((out < 0 && next > 0) || (out > 0 && next < 0))
        inner.push_back({glm::mix(from.place, to.place, share), glm::mix(from.aside, to.aside, share)});
    }
    return inner;
  }

  static double areaOf(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 from = outline[i].place;
      const glm::dvec2 to = outline[(i + 1) % outline.size()].place;
      twice += from.x * to.y - from.y * to.x;
    }
    return twice / 2;
  }

  // The top above a point of the outline. On two edges, in a corner, it lies in both bisecting planes.
  glm::dvec3 topOf(glm::dvec2 point, double height) const {
    glm::dvec2 shift(0);
    glm::dvec2 sum(0);
    int edges = 0;
    for (const glm::dvec2 edge : leans_) {
      if (glm::dot(edge, point) < solid_.apothem() - 1e-6) continue;
      sum += edge;
      ++edges;
    }
    if (edges > 0) shift = sum * (height * lean_ * edges / glm::dot(sum, sum));
    return {point + shift, height};
  }

  void addTop(const Outline& outline, const Wall& wall) {
    const std::size_t first = mesh_.vertices.size();
    for (const Corner& corner : outline) {
      addVertex(topOf(corner.place, wall.height), {0, 0, 1}, wall.colour);
      for (int i = 0; i < 2; ++i) {
        const double scaled = std::clamp(corner.aside[i] * WallVertex::kAsideScale, -127.0, 127.0);
        mesh_.vertices.back().aside[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(scaled));
      }
    }
    for (std::size_t i = 2; i < outline.size(); ++i) addTriangle(first, first + i - 1, first + i);
  }

  void addSide(glm::dvec2 from, glm::dvec2 to, const Wall& wall) {
    const glm::dvec3 low0(from, 0);
    const glm::dvec3 low1(to, 0);
    const glm::dvec3 top0 = topOf(from, wall.height);
    const glm::dvec3 top1 = topOf(to, wall.height);
    const glm::dvec3 across = glm::cross(top1 - low0, top0 - low1);
    if (glm::length(across) < 1e-9) return;
    const glm::dvec3 normal = glm::normalize(across);
    const std::size_t first = mesh_.vertices.size();
    for (const glm::dvec3 place : {low0, low1, top1, top0}) addVertex(place, normal, wall.colour);
    addTriangle(first, first + 1, first + 2);
    addTriangle(first, first + 2, first + 3);
  }

  void addVertex(glm::dvec3 place, glm::dvec3 normal, Colour colour) {
    const auto byte = [](double value) { return static_cast<std::int8_t>(std::lround(value * 127)); };
    const auto shade = [](float value) { return static_cast<std::uint8_t>(std::lround(value * 255)); };
    mesh_.vertices.push_back({glm::vec3(place),
                              {byte(normal.x), byte(normal.y), byte(normal.z), 0},
                              {shade(colour.r), shade(colour.g), shade(colour.b), 255},
                              {},
                              {}});
  }

  void addTriangle(std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t index : {a, b, c}) mesh_.triangles.push_back(static_cast<std::uint32_t>(index));
  }

  const SolidMesh& solid_;
  const EdgeMeetings& meetings_;
  int face_ = -1;
  std::vector<glm::dvec2> leans_;  // normals of the edges over which the wall goes on
  int partsOfEnd_;
  double lean_;  // outward shift of a top on an edge, by its height
  WallMesh mesh_;
};

}  // namespace

WallMesh makeWallMesh(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces,
                      const EdgeMeetings& meetings) {
  std::size_t count = 0;
  for (const std::vector<Wall>& walls : wallsOfFaces) count += walls.size();
  WallMeshBuilder builder(solid, meetings, partsOfAnEnd(count));
  for (const std::vector<Wall>& walls : wallsOfFaces) {
    builder.beginFace();
    for (const Wall& wall : walls) builder.add(wall);
    builder.endFace();
  }
  return builder.take();
}

WallMesh makeWallMesh(const SolidMesh& solid, std::span<const std::vector<Wall>> wallsOfFaces) {
  return makeWallMesh(solid, wallsOfFaces, EdgeMeetings(solid, wallsOfFaces));
}

}  // namespace platon
