#include "client/scene/camera_target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace platon {
namespace {

constexpr double kMinView = 460;  // shorter side of the picture at the player, level units
constexpr double kMaxView = 760;
constexpr double kViewOfFace = 1.3;  // the same in incircle diameters of a face, between the two bounds
constexpr double kZoneOfFace = 0.5;  // largest edge zone in apothems
constexpr double kMostOfZone = 0.5;  // of a rise that is not seen yet
constexpr double kLevelFrom = 0.5;   // distance from an edge in zones, from which floors become level on the way
constexpr double kLevelTo = 1.5;
constexpr double kPartOfRay = 0.35;  // more shows more of the neighbours, and tilts the floors more

double depthBelow(const SolidMesh& mesh, int face, glm::dvec3 place) {
  return mesh.inradius() - glm::dot(mesh.normal(face), place);
}

double zoneOf(const SolidMesh& mesh) { return std::min(CameraTarget::kEdgeZone, kZoneOfFace * mesh.apothem()); }

// From 0 to 1 in the zone at the edge of a neighbouring face, for the depth below its plane: so that the mean of both
// normals turns evenly on the way over the edge.
double nearness(const SolidMesh& mesh, double depth) {
  const double part = std::max(depth, 0.0) / (zoneOf(mesh) * std::sin(mesh.dihedral()));
  return std::max(1 - part, 0.0) / (1 + part);
}

double weightOf(PeekWeights weights, int face) { return weights.empty() ? 1 : weights[static_cast<std::size_t>(face)]; }

// An edge of the player's face.
struct NearEdge {
  double distance = 0;  // of the player, level units
  int beyond = 0;       // the face there
  glm::dvec3 along{0};  // unit
};

// The edges of the player's face, the nearest first.
std::vector<NearEdge> edgesByDistance(const SolidMesh& mesh, const Pose& player) {
  std::vector<NearEdge> edges;
  const int own = mesh.faceTowards(player.normal);
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    const int beyond = static_cast<int>(mesh.solid().neighbour(own, edge).face);
    const double depth = std::max(depthBelow(mesh, beyond, player.position), 0.0);
    const glm::dvec3 along = glm::normalize(glm::cross(player.normal, mesh.normal(beyond)));
    edges.push_back({depth / std::sin(mesh.dihedral()), beyond, along});
  }
  std::sort(edges.begin(), edges.end(), [](const NearEdge& a, const NearEdge& b) { return a.distance < b.distance; });
  return edges;
}

// The share of the nearest edge in the turn of the picture near two edges, -1 … 1 from the second one to it: as even
// as the way round their corner. Where two edges are equally far, 0.
double shareOfNearest(const std::vector<NearEdge>& edges) {
  const double first = edges[0].distance;
  const double second = edges[1].distance;
  const double third = edges[2].distance;
  const double interior = std::numbers::pi * (1 - 2.0 / static_cast<double>(edges.size()));
  const double nearest = second * (third - first);
  const double next = first * (third - second);
  if (nearest + next <= 0) return 0;
  return std::atan((nearest - next) / (nearest + next) * std::tan(interior / 2)) / (interior / 2);
}

// The angle about `back` by which an edge is aslant if the face is tilted the shortest way to `back`.
double slant(const NearEdge& edge, glm::dvec3 normal, glm::dvec3 back) {
  return angleAbout(back, rotatedBetween(edge.along, normal, back), edge.along - back * glm::dot(back, edge.along));
}

// The player's right in the picture of a player who moves. The face is tilted to `back`, and turned so that the nearest
// edge lies in the picture as it does in space: so both its faces agree there, whichever way the player's up points.
glm::dvec3 rightOf(const Pose& player, const std::vector<NearEdge>& edges, glm::dvec3 back, PeekWeights weights) {
  const double share = shareOfNearest(edges);
  const double turn = (1 + share) / 2 * weightOf(weights, edges[0].beyond) * slant(edges[0], player.normal, back) +
                      (1 - share) / 2 * weightOf(weights, edges[1].beyond) * slant(edges[1], player.normal, back);
  const glm::dvec3 right = rotatedBetween(glm::cross(player.up, player.normal), player.normal, back);
  return glm::angleAxis(turn, back) * right;
}

}  // namespace

double angleAbout(glm::dvec3 axis, glm::dvec3 from, glm::dvec3 to) {
  return std::atan2(glm::dot(axis, glm::cross(from, to)), glm::dot(from, to));
}

glm::dquat levelOrientation(glm::dvec3 back, glm::dvec3 right) {
  glm::dvec3 seen = right - back * glm::dot(back, right);
  // If `right` is parallel to `back`, any perpendicular direction is used.
  if (glm::length(seen) < 1e-9) seen = glm::cross(glm::dvec3(back.y, back.z, back.x) + glm::dvec3(0.5, 0, 0), back);
  seen = glm::normalize(seen);
  return glm::normalize(glm::quat_cast(glm::dmat3(seen, glm::cross(back, seen), back)));
}

// The depth below the plane of a face is the same function of the place on every face, so the sum has no jump at edges.
glm::dvec3 roundedNormal(const SolidMesh& mesh, glm::dvec3 place, PeekWeights weights) {
  glm::dvec3 sum(0);
  for (int face = 0; face < mesh.faces(); ++face)
    sum += mesh.normal(face) * weightOf(weights, face) * nearness(mesh, depthBelow(mesh, face, place));
  return glm::normalize(sum);
}

CameraTarget cameraTarget(const Pose& player, const SolidMesh& mesh, double zoom, const Peek& peek) {
  const std::vector<NearEdge> edges = edgesByDistance(mesh, player);
  const double rise = std::clamp(peek.rise, 0.0, kMostOfZone * zoneOf(mesh));
  const glm::dvec3 place = mesh.onSurface(player.position - rise * player.up);
  const glm::dvec3 ray = glm::normalize(place);
  const glm::dvec3 back = glm::normalize(glm::mix(roundedNormal(mesh, place, peek.weights), ray, kPartOfRay));
  const double view = std::clamp(2 * mesh.apothem() * kViewOfFace, kMinView, kMaxView) / zoom;
  const double level = glm::smoothstep(kLevelFrom, kLevelTo, edges[0].distance / zoneOf(mesh));
  return {levelOrientation(back, rightOf(player, edges, back, peek.weights)), view / 2 / CameraTarget::kTangent, level};
}

namespace {

constexpr double kPart = 0.85;  // of the way to the centre, up to the largest shift

}  // namespace

// What is across the line of sight has no jump at an edge, as the line of sight has none.
glm::dvec2 framingShift(const CameraTarget& target, glm::dvec3 place, const SolidMesh& mesh) {
  const glm::dvec2 wanted = -kPart * glm::dvec2(glm::conjugate(target.orientation) * place);
  const double halfView = target.halfView();
  const double longest = kMaxFramingShift * halfView * std::min(1.0, halfView / mesh.apothem());
  const double length = glm::length(wanted);
  return length > longest ? wanted * (longest / length) : wanted;
}

glm::dvec3 framedOffset(const CameraTarget& target, glm::dvec3 place, const SolidMesh& mesh) {
  return {framingShift(target, place, mesh), target.distance};
}

// In the picture, a direction at a place is seen as its part across the way from the eye to there. That way depends on
// the roll, through the framing; each round leaves a small part of the error.
CameraTarget levelled(CameraTarget target, const Pose& player, const SolidMesh& mesh) {
  constexpr int kRounds = 6;
  const glm::dvec3 right = glm::cross(player.up, player.normal);
  const glm::dvec3 back = target.back();
  target.orientation = levelOrientation(back, right);
  for (int round = 0; round < kRounds; ++round) {
    const glm::dvec3 way = target.orientation * framedOffset(target, player.position, mesh);
    target.orientation = levelOrientation(back, right - way * (glm::dot(right, back) / glm::dot(way, back)));
  }
  return target;
}

namespace {

struct Knot {
  double trail = 0;
  double lookAhead = 0;
};

// The look-ahead is linear between the knots, and odd. In a jump the player is at most 50 from the trailing point.
using Knots = std::array<Knot, 4>;
constexpr Knots kRight{{{0, 0}, {30, 0}, {60, 20}, {125, LookAhead::kMax}}};
constexpr Knots kUp{{{0, 0}, {40, -30}, {70, -30}, {160, LookAhead::kMax}}};
constexpr Knots kReducedRight{{{0, 0}, {30, 0}, {60, 0}, {125, 0}}};
constexpr Knots kReducedUp{{{0, 0}, {40, -30}, {70, -30}, {160, -30}}};

// Between two knots the look-ahead is base + slope · trail, the trail falls exponentially, and the differential
// equation of the following point has a closed solution.
double followedLookAhead(const Knots& knots, double trail, double follow, double seconds) {
  const double share = follow / (follow - LookAhead::kTrailRate);
  double size = std::abs(trail);
  double place = 0;
  for (std::size_t i = knots.size() - 1; i > 0; --i) {
    const Knot& low = knots[i - 1];
    if (size <= low.trail) continue;
    const double slope = (knots[i].lookAhead - low.lookAhead) / (knots[i].trail - low.trail);
    const double base = low.lookAhead - slope * low.trail;
    const double toKnot = low.trail > 0 ? std::log(size / low.trail) / LookAhead::kTrailRate : seconds;
    const double time = std::min(seconds, toKnot);
    const double nextSize = size * std::exp(-LookAhead::kTrailRate * time);
    place = (place - base - share * slope * size) * std::exp(-follow * time) + base + share * slope * nextSize;
    size = nextSize;
    seconds -= time;
  }
  return std::copysign(1.0, trail) * place;
}

}  // namespace

void LookAhead::reset(const Pose& player) {
  place_ = player.position;
  trail_ = glm::dvec2(0);
}

void LookAhead::move(const Pose& player) {
  const glm::dvec3 way = player.position - place_;
  trail_ += glm::dvec2(glm::dot(way, glm::cross(player.up, player.normal)), glm::dot(way, player.up));
  const glm::dvec2 longest(kRight.back().trail, kUp.back().trail);
  trail_ = glm::clamp(trail_, -longest, longest);
  place_ = player.position;
}

void LookAhead::wait(double seconds) { trail_ *= std::exp(-kTrailRate * seconds); }

glm::dvec2 LookAhead::followed(double follow, double seconds, bool reduced) const {
  return {followedLookAhead(reduced ? kReducedRight : kRight, trail_.x, follow, seconds),
          followedLookAhead(reduced ? kReducedUp : kUp, trail_.y, follow, seconds)};
}

namespace {

constexpr double kWholeFace = 1.13;    // shorter side of the picture in diameters of the face
constexpr double kMinWholeView = 460;  // level units
constexpr double kMaxWholeView = 1000;
constexpr double kBorder = 0.7;   // half the part of the picture in which the player stays
constexpr double kTurned = 0.02;  // radians by which the player may turn on the screen

}  // namespace

ViewPoint FaceHold::view(const Pose& player, const SolidMesh& mesh, double zoom) {
  if (view_ && holds(player, zoom)) return *view_;
  const double whole = std::max(kMinWholeView, kWholeFace * 2 * glm::length(mesh.polygon()[0]));
  whole_ = whole <= kMaxWholeView && zoom <= 1;
  normal_ = player.normal;
  zoom_ = zoom;
  centre_ = whole_ ? mesh.inradius() * normal_ : player.position;
  distance_ = whole_ ? whole / zoom / 2 / CameraTarget::kTangent : cameraTarget(player, mesh, zoom).distance;
  view_ = {levelOrientation(normal_, glm::cross(player.up, normal_)), centre_ + distance_ * normal_};
  return *view_;
}

bool FaceHold::holds(const Pose& player, double zoom) const {
  if (zoom != zoom_ || glm::dot(player.normal, normal_) < 1 - 1e-9) return false;
  const glm::dvec3 right = glm::conjugate(view_->orientation) * glm::cross(player.up, player.normal);
  if (std::abs(std::atan2(right.y, right.x)) > kTurned) return false;
  const glm::dvec3 offset = glm::abs(glm::conjugate(view_->orientation) * (player.position - centre_));
  return whole_ || std::max(offset.x, offset.y) < kBorder * CameraTarget::kTangent * distance_;
}

}  // namespace platon
