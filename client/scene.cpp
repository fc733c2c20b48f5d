#include "client/scene.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

// Longer ways in one tick are jumps, as back to the start, and not drawn in between.
constexpr double kLongestWay = 128;

Pose poseOf(const SolidMesh& mesh, const EntityState& entity) {
  return mesh.pose(static_cast<int>(entity.part), toUnits(entity.position), toRadians(entity.angle));
}

// Without the part along `normal`; `fallback` when nothing else is left.
glm::dvec3 tangent(glm::dvec3 vector, glm::dvec3 normal, glm::dvec3 fallback) {
  const glm::dvec3 flat = vector - normal * glm::dot(vector, normal);
  return glm::length(flat) > 1e-6 ? glm::normalize(flat) : fallback;
}

Pose between(const SolidMesh& mesh, const Pose& before, const Pose& now, double fraction) {
  if (glm::distance(before.position, now.position) > kLongestWay) return now;
  const glm::dvec3 position = mesh.onSurface(glm::mix(before.position, now.position, fraction));
  const glm::dvec3 normal = mesh.normal(mesh.faceTowards(position));
  return {position, tangent(glm::mix(before.up, now.up, fraction), normal, now.up), normal};
}

Pose poseIn(const GameInTime& time, const SolidMesh& mesh, std::uint32_t slot) {
  const Pose now = poseOf(mesh, time.game->world().entities()[slot]);
  if (slot >= time.before.size() || time.before[slot].inserted == 0) return now;
  return between(mesh, poseOf(mesh, time.before[slot]), now, time.fraction);
}

// Small: longer than an edge it would not follow the surface.
void shift(Pose& pose, const SolidMesh& mesh, glm::dvec2 offset) {
  const glm::dvec3 right = glm::cross(pose.up, pose.normal);
  pose.position = mesh.onSurface(pose.position + offset.x * right + offset.y * pose.up);
  pose.normal = mesh.normal(mesh.faceTowards(pose.position));
  pose.up = tangent(pose.up, pose.normal, pose.up);
}

PlayerDrawing drawingOf(const SceneSource& source, const GameInTime& time, std::uint32_t slot, bool own) {
  PlayerDrawing player;
  player.slot = slot;
  player.pose = poseIn(time, source.stage->mesh, slot);
  if (own && source.ownOffset != Point()) shift(player.pose, source.stage->mesh, toUnits(source.ownOffset));
  player.colour = playerColour(slot);
  player.number = std::to_string(slot + 1);
  if (slot < source.names.size()) player.name = source.names[slot];
  player.own = own;
  const PlayerState& state = time.game->player(slot);
  if (state.finished != 0) player.finishedAfter = double{1} * state.finishedAt / kTicksPerSecond;
  return player;
}

void addPlayers(Scene& scene, const SceneSource& source, const GameInTime& own) {
  const auto add = [&](const GameInTime& time, std::uint32_t slot, bool isOwn) {
    const bool known = slot < time.game->slots() && time.game->player(slot).present != 0;
    if (!known || time.game->world().entities()[slot].inserted == 0) return;
    scene.players.push_back(drawingOf(source, time, slot, isOwn));
  };
  for (std::uint32_t slot = 0; slot < source.others.game->slots(); ++slot) {
    if (slot != source.ownSlot) add(source.others, slot, false);
  }
  if (source.ownSlot) add(own, *source.ownSlot, true);
}

Pose focusOf(const Scene& scene) {
  if (!scene.players.empty()) return scene.players.back().own ? scene.players.back().pose : scene.players.front().pose;
  const Marker& start = scene.stage->start;
  return scene.stage->mesh.pose(start.face, start.place, start.angle);
}

}  // namespace

Scene makeScene(const SceneSource& source) {
  const GameInTime& own = source.own.game != nullptr ? source.own : source.others;
  Scene scene;
  scene.stage = source.stage;
  addPlayers(scene, source, own);
  scene.focus = focusOf(scene);
  const double passed = std::max(0.0, own.game->tick() - 1 + own.fraction);
  scene.seconds = passed / kTicksPerSecond;
  scene.secondsLeft = double{1} * own.game->ticksLeft() / kTicksPerSecond;
  scene.over = own.game->over();
  return scene;
}

}  // namespace platon
