#include "client/scene/scene.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "client/netcode/player_snapshot.h"
#include "client/scene/pose_between.h"

namespace platon {
namespace {

constexpr float kGhostOpacity = 0.5F;
constexpr std::uint32_t kFirstGhostColour = 4;
constexpr const char* kGhostLabel = "\u25cb";

// Shifts a pose along the surface. `offset` is in the player's frame and shorter than an edge.
void shift(Pose& pose, const SolidMesh& mesh, glm::dvec2 offset) {
  const glm::dvec3 right = glm::cross(pose.up, pose.normal);
  pose.position = mesh.onSurface(pose.position + offset.x * right + offset.y * pose.up);
  const glm::dvec3 normal = mesh.normal(mesh.faceTowards(pose.position));
  pose.up = rotatedBetween(pose.up, pose.normal, normal);
  pose.normal = normal;
}

PlayerDrawing drawingOf(const SceneSource& source, const InterpolatedPlayer& time, std::uint32_t slot, bool local) {
  PlayerDrawing player;
  player.slot = slot;
  player.pose = poseBetween(source.stage->mesh, time);
  if (local && source.localOffset != Point()) shift(player.pose, source.stage->mesh, toUnits(source.localOffset));
  if (slot < source.flashes.size()) player.flash = static_cast<float>(source.flashes[slot]);
  const BallLook look = lookOf(slot, source.localSlot, source.ownBall);
  player.colour = ballColour(look.colour);
  player.pattern = look.pattern;
  player.number = std::to_string(slot + 1);
  if (slot < source.names.size()) player.name = source.names[slot];
  if (slot < source.roundTrips.size()) player.roundTripMs = source.roundTrips[slot];
  player.local = local;
  if (time.now.finishTicks != 0) player.finishSeconds = secondsOf(time.now.finishTicks);
  return player;
}

void addPlayers(Scene& scene, const SceneSource& source) {
  const auto add = [&](const InterpolatedPlayer& time, std::uint32_t slot, bool local) {
    if (time.before.present && time.now.present) scene.players.push_back(drawingOf(source, time, slot, local));
  };
  for (std::uint32_t slot = 0; slot < source.others.now.size(); ++slot) {
    if (slot != source.localSlot) add(source.others.at(slot), slot, false);
  }
  if (source.localSlot)
    add(source.local ? *source.local : source.others.at(*source.localSlot), *source.localSlot, true);
}

// The local player's own ghost is white, the others have colours that the first players do not have.
void addGhosts(Scene& scene, const SceneSource& source) {
  for (std::uint32_t i = 0; i < source.ghosts.size(); ++i) {
    const GhostSource& ghost = source.ghosts[i];
    if (!ghost.player.before.present || !ghost.player.now.present) continue;
    PlayerDrawing drawing;
    drawing.slot = i;
    drawing.pose = poseBetween(scene.stage->mesh, ghost.player);
    drawing.colour = ghost.own ? Colour(1) : playerColour(kFirstGhostColour + i);
    drawing.number = kGhostLabel;
    drawing.name = ghost.name;
    drawing.opacity = kGhostOpacity;
    scene.ghosts.push_back(std::move(drawing));
  }
}

Pose focusOf(const Scene& scene) {
  if (!scene.players.empty())
    return scene.players.back().local ? scene.players.back().pose : scene.players.front().pose;
  const Marker& start = scene.stage->start;
  return scene.stage->mesh.pose(start.face, start.place, start.angle);
}

}  // namespace

Scene makeScene(const SceneSource& source) {
  Scene scene;
  scene.stage = source.stage;
  scene.elements = elementStatesOf(*source.game, source.localSlot, source.stage->mesh);
  addPlayers(scene, source);
  addGhosts(scene, source);
  scene.focus = focusOf(scene);
  const double passed = std::max(0.0, double{1} * source.game->tick() - 1 + source.fraction);
  scene.seconds = secondsOf(passed);
  scene.secondsLeft = secondsOf(source.game->ticksLeft());
  scene.timed = source.timed;
  scene.over = source.roundOver || (source.timed && source.game->over());
  const std::uint32_t needed = source.game->level().players;
  if (source.othersCanJoin && scene.players.size() < needed && !scene.over) scene.neededPlayers = needed;
  if (!scene.players.empty() && scene.players.back().local) {
    scene.attempt = {secondsOf(source.attempt.ticks()), source.attempt.arrived()};
    scene.needsRestart = source.needsRestart && !scene.over;
  }
  return scene;
}

}  // namespace platon
