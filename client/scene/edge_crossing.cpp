#include "client/scene/edge_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace platon {
namespace {

double side(glm::dvec2 from, glm::dvec2 to, glm::dvec2 point) {
  const glm::dvec2 way = to - from;
  const glm::dvec2 aside = point - from;
  return way.x * aside.y - way.y * aside.x;
}

bool cross(const Ribbon& ends, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 a(ends.a);
  const glm::dvec2 b(ends.b);
  return side(from, to, a) * side(from, to, b) <= 0 && side(a, b, from) * side(a, b, to) < 0;
}

bool blocks(const ElementDrawing& drawing, const ElementStates& states) {
  switch (drawing.kind) {
    case ElementKind::kPlate:
      return true;
    case ElementKind::kDoor:
    case ElementKind::kTimed:
    case ElementKind::kUp:
      return drawing.element < states.active.size() && states.active[drawing.element] != 0;
    case ElementKind::kOneway:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
    case ElementKind::kKey:
      return false;
  }
  return false;
}

}  // namespace

bool wayIsFree(const StageModel& stage, const ElementStates& states, int face, glm::dvec2 from, glm::dvec2 to) {
  const FaceDrawing& drawing = stage.faces[static_cast<std::size_t>(face)];
  const auto isAcross = [&](const Ribbon& ends) { return cross(ends, from, to); };
  return std::none_of(drawing.ribbons.begin(), drawing.ribbons.end(), isAcross) &&
         std::none_of(drawing.elements.begin(), drawing.elements.end(),
                      [&](const ElementDrawing& element) { return blocks(element, states) && isAcross(element.ends); });
}

namespace {

constexpr double kFullSpeed = 60;  // towards an edge, from which it has its full light, level units a second
constexpr double kRise = 0.12;
constexpr double kArrowFade = 0.35;
constexpr double kTintFade = 0.9;

// The angle of a marker whose up is this.
double angleOf(glm::dvec2 up) { return std::atan2(-up.x, up.y); }

int faceOf(const SolidMesh& mesh, const Pose& pose) { return mesh.faceTowards(pose.normal); }

// In the frame of the face.
glm::dvec2 onFace(const SolidMesh& mesh, int face, glm::dvec3 vector, double w) {
  return glm::dvec2(glm::inverse(mesh.faceToWorld(face)) * glm::dvec4(vector, w));
}

// An edge of a face, and the point of its line that is nearest to a place on the face, in the frame of the face.
struct EdgeFoot {
  glm::dvec2 outwards{0};  // unit
  double distance = 0;     // from the place
  double aside = 0;        // from the middle of the edge
  double height = 0;       // of the edge over the middle of the face

  glm::dvec2 at(double along) const { return height * outwards + along * glm::dvec2(-outwards.y, outwards.x); }
  glm::dvec2 point() const { return at(aside); }
};

EdgeFoot edgeFoot(const SolidMesh& mesh, int edge, glm::dvec2 place) {
  const glm::dvec2 outwards = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
  const glm::dvec2 along(-outwards.y, outwards.x);
  return {outwards, mesh.apothem() - glm::dot(outwards, place), glm::dot(along, place), mesh.apothem()};
}

}  // namespace

std::vector<double> freeFaces(const StageModel& stage, const ElementStates& states, const Pose& player) {
  const SolidMesh& mesh = stage.mesh;
  const int own = faceOf(mesh, player);
  const glm::dvec2 place = onFace(mesh, own, player.position, 1);
  std::vector<double> free(static_cast<std::size_t>(mesh.faces()), 0);
  std::vector<bool> isBeside(free.size());
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    const EdgeFoot foot = edgeFoot(mesh, edge, place);
    const double half = mesh.faceSize() / 2;
    const std::size_t next = mesh.solid().neighbour(own, edge).face;
    isBeside[next] = true;
    free[next] = wayIsFree(stage, states, own, place, foot.at(std::clamp(foot.aside, -half, half))) ? 1 : 0;
  }
  for (std::size_t face = 0; face < free.size(); ++face) {
    if (isBeside[face] || face == static_cast<std::size_t>(own)) continue;
    double least = 1;
    for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
      const std::size_t between = mesh.solid().neighbour(static_cast<int>(face), edge).face;
      if (isBeside[between]) least = std::min(least, free[between]);
    }
    free[face] = least;
  }
  free[static_cast<std::size_t>(own)] = 1;
  return free;
}

void EdgeCrossing::advance(const StageModel& stage, const ElementStates& states, const Pose& pose, double seconds) {
  const double passed = seconds - seconds_;
  const glm::dvec3 way = pose.position - pose_.position;
  const int face = faceOf(stage.mesh, pose);
  if (!begun_ || passed < 0 || glm::length(way) > kMaxStep) return begin(pose, face, seconds);
  if (passed == 0) return;
  const bool crossed = face != face_;
  face_ = face;
  fade(passed);
  light(stage, states, pose, way, passed);
  follow(stage, pose, crossed, passed);
  spread(stage.mesh, pose, crossed, passed);
  pose_ = pose;
  seconds_ = seconds;
}

void EdgeCrossing::begin(const Pose& pose, int face, double seconds) {
  reset();
  begun_ = true;
  pose_ = pose;
  face_ = face;
  seconds_ = seconds;
}

void EdgeCrossing::fade(double passed) {
  for (Glow& glow : glows_) glow.light -= passed / kFadeSeconds;
  std::erase_if(glows_, [](const Glow& glow) { return glow.light <= 0; });
}

// An edge gets back what it has lost since the last picture, and more of the light that is still missing.
void EdgeCrossing::light(const StageModel& stage, const ElementStates& states, const Pose& pose, glm::dvec3 way,
                         double passed) {
  const SolidMesh& mesh = stage.mesh;
  const glm::dvec2 place = onFace(mesh, face_, pose.position, 1);
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    const EdgeFoot foot = edgeFoot(mesh, edge, place);
    const bool beside = std::abs(foot.aside) < mesh.faceSize() / 2;
    if (foot.distance > kReach || !beside || !wayIsFree(stage, states, face_, place, foot.point())) continue;
    const glm::dvec3 outwards(mesh.faceToWorld(face_) * glm::dvec4(foot.outwards, 0, 0));
    const double towards = glm::dot(outwards, way) / passed;
    const double wanted = glm::smoothstep(0.0, 1.0, 1 - foot.distance / kReach) *
                          glm::mix(kStill, 1.0, std::clamp(towards / kFullSpeed, 0.0, 1.0));
    Glow& glow = glowOf(mesh, edge);
    glow.foot = {face_, glm::vec2(foot.point()), angleOf(foot.outwards)};
    glow.light += std::clamp(wanted - glow.light, 0.0, passed * (1 / kRiseSeconds + 1 / kFadeSeconds));
  }
}

// The glow of an edge of the present face, which may have been lit from its other face.
EdgeCrossing::Glow& EdgeCrossing::glowOf(const SolidMesh& mesh, int edge) {
  const int beyond = mesh.solid().neighbour(face_, edge).face;
  const glm::dvec2 outwards = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
  const auto found = std::find_if(glows_.begin(), glows_.end(), [&](const Glow& glow) {
    if (glow.foot.face == face_) return std::abs(glow.foot.angle - angleOf(outwards)) < 1e-6;
    if (glow.foot.face != beyond) return false;
    const glm::dvec2 foot = glm::dvec2(mesh.unfolded(face_, edge) * glm::dvec4(glow.foot.place, 0, 1));
    return std::abs(glm::dot(outwards, foot) - mesh.apothem()) < 1e-3 * mesh.apothem();
  });
  return found == glows_.end() ? glows_.emplace_back() : *found;
}

// The arrow goes with the ball, and the tint with its face.
void EdgeCrossing::follow(const StageModel& stage, const Pose& pose, bool crossed, double passed) {
  const glm::dvec2 up = onFace(stage.mesh, face_, pose.up, 0);
  arrowAge_ = std::min(arrowAge_ + passed, kArrowSeconds);
  sinceCrossing_ = std::min(sinceCrossing_ + passed, kArrowPause);
  if (crossed && sinceCrossing_ >= kArrowPause) arrowAge_ = 0;
  if (crossed) sinceCrossing_ = 0;
  const glm::dvec2 place = onFace(stage.mesh, face_, pose.position, 1) - kArrowBelow * up;
  if (arrowAge_ < kArrowSeconds) arrow_ = {face_, glm::vec2(place), angleOf(up)};
  tintAge_ = crossed ? kRise * tint_.light : std::min(tintAge_ + passed, kTintSeconds);
  tint_ = {face_, glm::vec2(up), std::min({1.0, tintAge_ / kRise, (kTintSeconds - tintAge_) / kTintFade})};
}

// From the edge that is nearest after the crossing.
void EdgeCrossing::spread(const SolidMesh& mesh, const Pose& pose, bool crossed, double passed) {
  waveAge_ = std::min(waveAge_ + passed, kWavePause);
  if (!crossed || waveAge_ < kWavePause) return;
  const glm::dvec2 place = onFace(mesh, face_, pose.position, 1);
  EdgeFoot nearest = edgeFoot(mesh, 0, place);
  for (int edge = 1; edge < mesh.solid().edgesPerFace(); ++edge) {
    const EdgeFoot foot = edgeFoot(mesh, edge, place);
    if (foot.distance < nearest.distance) nearest = foot;
  }
  wave_ = {face_, glm::vec2(nearest.point()), angleOf(nearest.outwards)};
  waveAge_ = 0;
}

std::optional<EdgeCrossing::Wave> EdgeCrossing::wave() const {
  return waveAge_ < kWaveSeconds ? std::optional(Wave{wave_, waveAge_ / kWaveSeconds}) : std::nullopt;
}

std::optional<EdgeCrossing::Arrow> EdgeCrossing::arrow() const {
  if (arrowAge_ >= kArrowSeconds) return std::nullopt;
  return Arrow{arrow_, std::min({1.0, arrowAge_ / kRise, (kArrowSeconds - arrowAge_) / kArrowFade})};
}

}  // namespace platon
