#include "client/scene/look/wall_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
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
