#include "client/demo/planner.h"

#include <algorithm>
#include <array>

namespace platon {

namespace {

constexpr std::size_t kMaxNodes = 400000;
constexpr std::uint32_t kStride = 6;         // ticks for which each choice of buttons is held
constexpr std::int64_t kSpeed = 3277;        // running speed, subunits per tick
constexpr std::int64_t kDistanceWeight = 2;  // of the remaining distance relative to the time taken
constexpr std::int64_t kUnreachableCost = std::int64_t{1} << 40;
constexpr std::int32_t kPositionStep = 8 * kSubunitsPerUnit;  // closer states count as equal
constexpr std::int32_t kVelocityStep = 2 * kSubunitsPerUnit;

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

}  // namespace

Planner::Planner(const Game& start, std::uint32_t slot, GoalDistance& distance)
    : distance_(&distance), game_(start), slot_(slot), inputs_(slot + 1) {
  nodes_.push_back({0, 0, 0, game_.save()});
  open_.push_back({0, 0});
}

Planner::Status Planner::work(std::uint32_t ticks) {
  constexpr std::uint32_t kTicksToExpand = kStride * kChoices.size();
  for (std::uint32_t done = 0; done < ticks && status_ == Status::kSearching; done += kTicksToExpand) {
    if (open_.empty() || nodes_.size() > kMaxNodes) {
      status_ = Status::kNoPlan;
      break;
    }
    std::pop_heap(open_.begin(), open_.end());
    const std::uint32_t index = open_.back().node;
    open_.pop_back();
    expand(index);
  }
  return status_;
}

void Planner::expand(std::uint32_t index) {
  const std::vector<std::uint8_t> state = std::move(nodes_[index].state);
  for (const std::uint8_t buttons : kChoices) {
    game_.restore(state);
    if (const std::uint32_t ticks = simulate(buttons); ticks != 0) return finish(index, buttons, ticks);
    if (!game_.over() && seen_.insert(signature()).second) keep(index, buttons);
  }
}

std::uint32_t Planner::simulate(std::uint8_t buttons) {
  inputs_[slot_] = {static_cast<std::uint8_t>(buttons | Input::kPresent)};
  for (std::uint32_t tick = 1; tick <= kStride; ++tick) {
    game_.advance(inputs_);
    if (game_.player(slot_).finished()) return tick;
  }
  return 0;
}

void Planner::keep(std::uint32_t parent, std::uint8_t buttons) {
  const std::uint32_t depth = nodes_[parent].depth + 1;
  open_.push_back({cost(depth), static_cast<std::uint32_t>(nodes_.size())});
  std::push_heap(open_.begin(), open_.end());
  nodes_.push_back({parent, depth, buttons, game_.save()});
}

std::int64_t Planner::cost(std::uint32_t depth) const {
  const EntityState& entity = game_.world().entities()[slot_];
  const std::int32_t left = distance_->from({entity.part, entity.position}, game_.openDoors());
  return depth * kStride * kSpeed + kDistanceWeight * (left == GoalDistance::kUnreachable ? kUnreachableCost : left);
}

std::uint64_t Planner::signature() const {
  const EntityState& entity = game_.world().entities()[slot_];
  const PlayerState& player = game_.player(slot_);
  std::uint64_t hash = mix(entity.part, static_cast<std::uint32_t>(entity.angle.centidegrees()));
  hash = mix(hash, entity.position, kPositionStep);
  hash = mix(hash, player.velocity, kVelocityStep);
  hash = mix(hash, game_.openDoors());
  const bool mayJump = player.coyote != 0 && (player.held & Input::kJump) == 0;
  return mix(hash, (mayJump ? 1u : 0u) | (player.jumping != 0 ? 2u : 0u));
}

void Planner::finish(std::uint32_t index, std::uint8_t buttons, std::uint32_t ticks) {
  const auto hold = [this](std::uint8_t held, std::uint32_t count) {
    plan_.insert(plan_.end(), count, Input{static_cast<std::uint8_t>(held | Input::kPresent)});
  };
  hold(buttons, ticks);
  // Collects the strides backwards. Within a stride all inputs are equal, so reversing them is harmless.
  for (; index != 0; index = nodes_[index].parent) hold(nodes_[index].buttons, kStride);
  std::reverse(plan_.begin(), plan_.end());
  status_ = Status::kFound;
}

}  // namespace platon
