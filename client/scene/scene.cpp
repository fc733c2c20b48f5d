#include "client/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "client/netcode/player_snapshot.h"

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

PlayerDrawing drawingOf(const SceneSource& source, const InterpolatedPlayer& time, std::uint32_t slot, Point offset) {
  PlayerDrawing player;
  player.slot = slot;
  player.pose = poseBetween(source.stage->mesh, time);
  if (offset != Point()) shift(player.pose, source.stage->mesh, toUnits(offset));
  if (slot < source.flashes.size()) player.flash = static_cast<float>(source.flashes[slot]);
  const BallAppearance appearance = appearanceOf(slot, source.ownBalls);
  player.colour = ballColour(appearance.colour);
  player.pattern = appearance.pattern;
  player.number = std::to_string(slot + 1);
  if (slot < source.names.size()) player.name = source.names[slot];
  if (slot < source.roundTrips.size()) player.roundTripMs = source.roundTrips[slot];
  player.local = slot == source.localSlot;
  if (time.now.finishTicks != 0) player.finishSeconds = secondsOf(time.now.finishTicks);
  return player;
}

void addPlayers(Scene& scene, const SceneSource& source) {
  const auto add = [&](const InterpolatedPlayer& time, std::uint32_t slot, Point offset) {
    if (time.before.present && time.now.present) scene.players.push_back(drawingOf(source, time, slot, offset));
  };
  const auto isCompanion = [&](std::uint32_t slot) {
    return std::any_of(source.companions.begin(), source.companions.end(),
                       [slot](const CompanionSource& companion) { return companion.slot == slot; });
  };
  for (std::uint32_t slot = 0; slot < source.others.now.size(); ++slot)
    if (slot != source.localSlot && !isCompanion(slot)) add(source.others.at(slot), slot, {});
  for (const CompanionSource& companion : source.companions) add(companion.player, companion.slot, companion.offset);
  std::sort(scene.players.begin(), scene.players.end(),
            [](const PlayerDrawing& a, const PlayerDrawing& b) { return a.slot < b.slot; });
  if (source.localSlot)
    add(source.local ? *source.local : source.others.at(*source.localSlot), *source.localSlot, source.localOffset);
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
  scene.begun = !source.localSlot || source.attempt.ticks() > 0;  // at first, nobody has appeared yet
  const std::uint32_t needed = source.game->level().players;
  scene.isTeam = needed > 1;
  if (scene.isTeam && source.team.arrived()) scene.teamSeconds = secondsOf(source.team.ticks());
  const bool tooFew = !scene.players.empty() && scene.players.size() < needed;
  if (source.othersCanJoin && tooFew && !scene.over) scene.neededPlayers = needed;
  if (!scene.players.empty() && scene.players.back().local) {
    scene.attempt = {secondsOf(source.attempt.ticks()), source.attempt.arrived()};
    scene.needsRestart = source.needsRestart && !scene.over;
    scene.longFall = source.longFall && !scene.over;
  }
  return scene;
}

namespace {

// Longest interpolated distance in one tick, level units: the fastest fall is 7.5, and slopes and jumps can add to it.
// A shorter jump is interpolated, too; that lasts one tick.
constexpr double kMaxTickDistance = 32;

struct FacePoint {
  int face = 0;
  glm::dvec2 point{0, 0};
};

FacePoint placeOf(const PlayerSnapshot& player) { return {static_cast<int>(player.part), toUnits(player.position)}; }

glm::dvec2 moved(const glm::dmat4& frame, glm::dvec2 point) { return glm::dvec2(frame * glm::dvec4(point, 0, 1)); }

// Interpolates over one edge. Returns nothing if the straight path does not cross this edge.
std::optional<FacePoint> overEdge(const SolidMesh& mesh, FacePoint before, int edge, FacePoint now, double fraction) {
  const glm::dmat4 unfolded = mesh.unfolded(before.face, edge);
  const glm::dvec2 outwards = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
  const glm::dvec2 path = moved(unfolded, now.point) - before.point;
  const double inside = mesh.apothem() - glm::dot(outwards, before.point);
  const double across = glm::dot(outwards, path);
  if (inside < 0 || across <= inside) return std::nullopt;
  const glm::dvec2 crossing = before.point + path * (inside / across);
  if (std::abs(glm::dot(glm::dvec2(-outwards.y, outwards.x), crossing)) > mesh.faceSize() / 2) return std::nullopt;
  const glm::dvec2 flat = before.point + path * fraction;
  if (across * fraction <= inside) return FacePoint{before.face, flat};
  return FacePoint{now.face, moved(glm::inverse(unfolded), flat)};
}

std::optional<FacePoint> alongSurface(const SolidMesh& mesh, FacePoint before, FacePoint now, double fraction) {
  if (before.face == now.face) return FacePoint{now.face, glm::mix(before.point, now.point, fraction)};
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    if (mesh.solid().neighbour(before.face, edge).face != now.face) continue;
    return overEdge(mesh, before, edge, now, fraction);
  }
  return std::nullopt;
}

glm::dvec3 upBetween(const Pose& before, const Pose& now, glm::dvec3 normal, double fraction) {
  const glm::dvec3 last = rotatedBetween(now.up, now.normal, normal);
  const glm::dvec3 up = glm::mix(rotatedBetween(before.up, before.normal, normal), last, fraction);
  return glm::normalize(glm::length(up) > 1e-6 ? up : last);
}

}  // namespace

Pose poseOf(const SolidMesh& mesh, const PlayerSnapshot& player) {
  return mesh.pose(static_cast<int>(player.part), toUnits(player.position), toRadians(player.angle));
}

Pose poseBetween(const SolidMesh& mesh, const InterpolatedPlayer& player) {
  const Pose before = poseOf(mesh, player.before);
  const Pose now = poseOf(mesh, player.now);
  if (glm::distance(before.position, now.position) > kMaxTickDistance) return now;
  const auto place = alongSurface(mesh, placeOf(player.before), placeOf(player.now), player.fraction);
  const glm::dvec3 position = place ? mesh.toWorld(place->face, place->point)
                                    : mesh.onSurface(glm::mix(before.position, now.position, player.fraction));
  const glm::dvec3 normal = mesh.normal(place ? place->face : mesh.faceTowards(position));
  return {position, upBetween(before, now, normal, player.fraction), normal};
}

}  // namespace platon
