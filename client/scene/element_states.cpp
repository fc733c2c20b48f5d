#include "client/scene/element_states.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "client/netcode/player_snapshot.h"

namespace platon {
namespace {

Pose poseOf(const Game& game, std::optional<std::uint32_t> local, const SolidMesh& mesh) {
  const PlayerSnapshot player = local ? snapshotOf(game, *local) : PlayerSnapshot();
  const Level& level = game.level();
  if (!player.present)
    return mesh.pose(static_cast<int>(level.startFace), toUnits(level.start), toRadians(level.startAngle));
  return mesh.pose(static_cast<int>(player.part), toUnits(player.position), toRadians(player.angle));
}

float clockOf(const Element& element, std::uint32_t tick) {
  if (element.kind != ElementKind::kTimed) return 0;
  const TimedPhase phase = phaseOf(element, tick);
  const float left = static_cast<float>(phase.ticksLeft) / static_cast<float>(phase.ticks);
  return phase.isOpen ? 1 - left : left;
}

}  // namespace

glm::dvec2 carriedUp(const SolidMesh& mesh, const Pose& pose, int face) {
  const glm::dvec3 normal = mesh.normal(face);
  if (glm::dot(pose.normal, normal) < -0.999) return {0, 1};
  const glm::dvec4 carried(rotatedBetween(pose.up, pose.normal, normal), 0);
  return glm::normalize(glm::dvec2(glm::inverse(mesh.faceToWorld(face)) * carried));
}

int edgeTowards(glm::dvec2 up, int edges) {
  const double turns = std::atan2(-up.x, up.y) / (2 * std::numbers::pi);
  const Angle angle(static_cast<std::int32_t>(std::lround(turns * Angle::kTurn)));
  Element element;
  element.kind = ElementKind::kUp;
  while (element.number < edges - 1 && !pointsTo(angle, element, edges)) ++element.number;
  return element.number;
}

ElementStates elementStatesOf(const Game& game, std::optional<std::uint32_t> local, const SolidMesh& mesh) {
  const std::vector<Element>& elements = game.level().elements;
  if (elements.empty()) return {};
  ElementStates states;
  const Pose pose = poseOf(game, local, mesh);
  for (int face = 0; face < mesh.faces(); ++face) states.ups.emplace_back(carriedUp(mesh, pose, face));
  const std::size_t checkpoint = local && *local < game.slots() ? game.player(*local).checkpoint : 0;
  const auto isActive = [&](const Element& element, std::size_t number) {
    switch (element.kind) {
      case ElementKind::kUp:
        return edgeTowards(states.ups[element.face], mesh.solid().edgesPerFace()) == element.number;
      case ElementKind::kCheckpoint:
        return checkpoint == number;
      case ElementKind::kKey:
        return !game.isTaken(element);
      case ElementKind::kDoor:
      case ElementKind::kTimed:
        return !game.open().has(element);
      case ElementKind::kPlate:
        return (game.openDoors() & element.bit()) != 0;
      case ElementKind::kOneway:
      case ElementKind::kHazard:
        return true;
    }
    return true;
  };
  for (const Element& element : elements) {
    states.active.push_back(isActive(element, states.active.size() + 1) ? 1 : 0);
    states.clocks.push_back(clockOf(element, game.tick()));
  }
  return states;
}

}  // namespace platon
