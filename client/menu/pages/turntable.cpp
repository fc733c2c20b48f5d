#include "client/menu/pages/turntable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"
#include "platon/game/game.h"

namespace platon {
namespace {

constexpr double kTurnPerSecond = 2 * std::numbers::pi / 40;
constexpr double kHeight = 0.45;                             // of the eye, in distances from the axis
constexpr double kDistance = 1.42 / CameraTarget::kTangent;  // of the eye, in circumradii, from the centre
constexpr double kLead = 0.5;                          // radians from which the face of the start comes to the front
constexpr double kShift = 2 * Turntable::kMiddle - 1;  // of the solid, in half widths of the picture

}  // namespace

void Turntable::show(const std::shared_ptr<const Level>& level) {
  if (level == level_) return;
  level_ = level;
  const Game game(level);
  SceneSource source;
  source.stage = makeStageModel(*level);
  source.game = &game;
  scene_ = makeScene(source);
  const glm::dvec3 front = source.stage->mesh.normal(source.stage->start.face);
  angle_ = std::atan2(front.z, front.x) - kLead;
}

void Turntable::advance(double seconds) { angle_ = std::fmod(angle_ + kTurnPerSecond * seconds, 2 * std::numbers::pi); }

Camera Turntable::camera(std::uint32_t w, std::uint32_t h) const {
  Camera camera;
  camera.resize(w, h);
  const glm::dvec3 direction(std::cos(angle_), kHeight, std::sin(angle_));
  const SolidMesh& mesh = scene_.stage->mesh;
  camera.place(glm::normalize(direction) * mesh.circumradius() * kDistance, {0, 1, 0}, mesh);
  const double aspect = double{1} * camera.width() / camera.height();
  camera.setShift(aspect > kWide ? kShift : 0);
  return camera;
}

}  // namespace platon
