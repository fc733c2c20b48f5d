#include "levels/solve/way_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "levels/solve/uses.h"

namespace platon {
namespace {

constexpr std::uint32_t kStride = 5;                          // ticks for which each choice of buttons is held
constexpr std::int32_t kPositionStep = 6 * kSubunitsPerUnit;  // closer states count as equal
constexpr std::int32_t kVelocityStep = 3 * kSubunitsPerUnit / 2;

constexpr std::array<std::uint8_t, 6> kChoices = {
    0, Input::kLeft, Input::kRight, Input::kJump, Input::kLeft | Input::kJump, Input::kRight | Input::kJump};

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 29;
}

std::uint64_t mix(std::uint64_t hash, Point point, std::int32_t step) {
  hash = mix(hash, static_cast<std::uint32_t>(divideFloor(point.x, step)));
  return mix(hash, static_cast<std::uint32_t>(divideFloor(point.y, step)));
}

std::optional<WaySearch::Target::Kind> targetOf(ElementKind kind) {
  switch (kind) {
    case ElementKind::kKey:
      return WaySearch::Target::Kind::kKey;
    case ElementKind::kPlate:
      return WaySearch::Target::Kind::kPlate;
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
    case ElementKind::kDoor:
    case ElementKind::kTimed:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

WaySearch::WaySearch(const Game& start, std::uint32_t slot, const Limits& limits)
    : game_(start),
      slot_(slot),
      limits_(limits),
      crossingsBefore_(start.world().entities()[slot].crossings),
      inputs_(start.slots(), Input{Input::kPresent}) {
  nodes_.push_back({0, 0, signature(), start.player(slot).held, game_.save()});
  costs_.emplace(signature(), 0);
  open_[0].push_back(0);
}

bool WaySearch::work(std::uint64_t ticks) {
  constexpr std::uint64_t ticksToExpand = kStride * kChoices.size();
  for (std::uint64_t done = 0; done < ticks && !open_.empty() && nodes_.size() < limits_.states; done += ticksToExpand)
    expand(takeCheapest());
  return !open_.empty() && nodes_.size() < limits_.states;
}

// A few milliseconds. Returns whether to go on.
bool WaySearch::workOn() {
  constexpr std::uint64_t ticks = 1000;
  return !(limits_.stop && limits_.stop()) && work(ticks);
}

bool WaySearch::find(const Target& target) {
  while (!found_.contains(target) && workOn()) {
  }
  return found_.contains(target);
}

void WaySearch::findAll() {
  while (workOn()) {
  }
}

std::uint32_t WaySearch::takeCheapest() {
  const auto cheapest = open_.begin();
  const std::uint32_t index = cheapest->second.back();
  cheapest->second.pop_back();
  if (cheapest->second.empty()) open_.erase(cheapest);
  return index;
}

void WaySearch::expand(std::uint32_t index) {
  const std::vector<std::uint8_t> state = std::move(nodes_[index].state);
  nodes_[index].state = {};
  if (costs_.at(nodes_[index].signature) != nodes_[index].cost) return;  // a cheaper way has been found
  game_.restore(state);
  const Game before = game_;
  for (const std::uint8_t buttons : kChoices) {
    game_ = before;
    if (simulate(index, buttons)) keep(index, buttons);
  }
}

void WaySearch::keep(std::uint32_t parent, std::uint8_t buttons) {
  const auto presses =
      static_cast<std::uint32_t>(std::popcount(static_cast<unsigned>(buttons & ~nodes_[parent].buttons)));
  const std::uint32_t cost = nodes_[parent].cost + kStride + presses * limits_.pressCost;
  const std::uint64_t here = signature();
  const auto [known, isNew] = costs_.emplace(here, cost);
  if (!isNew && known->second <= cost) return;
  known->second = cost;
  const std::uint32_t left = limits_.ticksLeft ? limits_.ticksLeft(game_) : 0;
  open_[cost + left].push_back(static_cast<std::uint32_t>(nodes_.size()));
  nodes_.push_back({parent, cost, here, buttons, game_.save()});
}

// Holds the buttons for a stride. Returns whether the way goes on from there.
bool WaySearch::simulate(std::uint32_t parent, std::uint8_t buttons) {
  inputs_[slot_] = {static_cast<std::uint8_t>(buttons | Input::kPresent)};
  for (std::uint32_t tick = 1; tick <= kStride; ++tick) {
    game_.advance(inputs_);
    if (limits_.crossings && game_.world().entities()[slot_].crossings - crossingsBefore_ > *limits_.crossings)
      return false;
    if (!keepsOff()) return false;
    noteTargets({parent, buttons, tick});
    if (game_.player(slot_).arrived != 0) return false;
  }
  return !game_.over();
}

// Whether the player has touched nothing of Limits::without.
bool WaySearch::keepsOff() const {
  const std::vector<Element>& elements = game_.level().elements;
  return limits_.without.empty() || std::none_of(elements.begin(), elements.end(), [&](const Element& element) {
           return isAmong(limits_.without, element) && uses(game_, slot_, element);
         });
}

void WaySearch::noteTargets(const Way& way) {
  if (game_.player(slot_).arrived != 0) note({Target::Kind::kGoal, 0}, way);
  if (game_.openDoors() == 0) return;
  const std::vector<Element>& elements = game_.level().elements;
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const auto kind = targetOf(elements[i].kind);
    if (kind && uses(game_, slot_, elements[i])) note({*kind, i}, way);
  }
}

std::uint64_t WaySearch::signature() const {
  const EntityState& entity = game_.world().entities()[slot_];
  const PlayerState& player = game_.player(slot_);
  std::uint64_t hash = mix(entity.part, static_cast<std::uint32_t>(entity.angle.centidegrees()));
  hash = mix(hash, entity.position, kPositionStep);
  hash = mix(hash, player.velocity, kVelocityStep);
  if (limits_.crossings) hash = mix(hash, entity.crossings);
  const bool mayJump = player.coyote != 0 && (player.held & Input::kJump) == 0;
  hash = mix(hash, (mayJump ? 1u : 0u) | (player.jumping != 0 ? 2u : 0u) | std::uint64_t{player.checkpoint} << 2);
  hash = mix(hash, game_.openDoors());
  if (!game_.level().isTimed) return hash;
  for (const Element& element : game_.level().elements) {
    if (element.kind != ElementKind::kTimed) continue;
    const TimedPhase phase = phaseOf(element, game_.tick());
    hash = mix(hash, std::uint64_t{phase.ticksLeft / kStride} << 1 | (phase.isOpen ? 1u : 0u));
  }
  return hash;
}

std::vector<Input> WaySearch::inputsTo(const Target& target) const {
  std::vector<Input> inputs;
  const auto hold = [&inputs](std::uint8_t buttons, std::uint32_t ticks) {
    inputs.insert(inputs.end(), ticks, Input{static_cast<std::uint8_t>(buttons | Input::kPresent)});
  };
  const Way& way = found_.at(target);
  hold(way.buttons, way.ticks);
  // Collects the strides backwards. Within a stride all inputs are equal, so reversing them is harmless.
  for (std::uint32_t index = way.parent; index != 0; index = nodes_[index].parent) hold(nodes_[index].buttons, kStride);
  std::reverse(inputs.begin(), inputs.end());
  return inputs;
}

}  // namespace platon
