#include "platon/game/game.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "platon/game/state_bytes.h"
#include "platon/physics/map_part.h"
#include "shared/exact/hash.h"
#include "shared/game/game_rules.h"

namespace platon {
namespace {

// A player touches the goal when their distance is below their radii together.
constexpr std::int64_t kGoalReach = kPlayerRadius + kGoalRadius;

}  // namespace

Game::Game(std::shared_ptr<const Level> level) : level_(std::move(level)), world_(level_->world) {
  world_.addShape(playerShape());
}

void Game::advance(std::span<const Input> inputs, StepObserver* observer) {
  assert(inputs.size() <= kMaxPlayers);
  touched_.keys = touched_.plates = 0;
  touched_.atHazard.clear();
  {
    const GameRules rules(*level_, world_, players_, unitNormals_, touched_, open());
    addAndRemovePlayers(inputs);
    for (std::uint32_t slot = 0; slot < players_.size(); ++slot) {
      if (players_[slot].present != 0) steer(slot, inputs[slot]);
    }
    world_.solve(observer);
    for (const std::uint32_t slot : touched_.atHazard) respawn(slot);
  }
  keys_ |= touched_.keys;
  plates_ = touched_.plates;
  ++tick_;
  updateFinishes();
}

void Game::steer(std::uint32_t slot, Input input) {
  PlayerState& player = players_[slot];
  if (input.has(Input::kRestart) && (player.held & Input::kRestart) == 0) restart(slot);
  if (player.startedAt == 0 && (input.buttons & Input::kMoves) != 0) player.startedAt = startOfAttempt();
  Player(world_, slot, player).tick(input);
}

// The tick from which an attempt that begins now is timed. Keys and plates are shared by all players, so a player who
// begins after another one is timed from the same tick.
std::uint32_t Game::startOfAttempt() const {
  std::uint32_t first = tick_ + 1;
  if (level_->doorNumbers == 0) return first;
  for (const PlayerState& player : players_) {
    if (player.startedAt != 0) first = std::min(first, player.startedAt);
  }
  return first;
}

std::uint32_t Game::presentPlayers() const {
  std::uint32_t present = 0;
  for (const PlayerState& player : players_) present += player.present;
  return present;
}

std::uint32_t Game::ticksLeft() const { return tick_ < kRoundTicks ? kRoundTicks - tick_ : 0; }

void Game::addAndRemovePlayers(std::span<const Input> inputs) {
  for (std::uint32_t slot = 0; slot < std::max(inputs.size(), players_.size()); ++slot) {
    const bool wanted = slot < inputs.size() && inputs[slot].has(Input::kPresent);
    const bool present = slot < players_.size() && players_[slot].present != 0;
    if (wanted && !present) addPlayer(slot);
    if (!wanted && present) removePlayer(slot);
  }
}

void Game::addPlayer(std::uint32_t slot) {
  while (players_.size() <= slot) {
    (void)Entity(world_, playerShape());
    players_.emplace_back();
  }
  players_[slot] = {};
  players_[slot].present = 1;
  respawn(slot);
}

void Game::removePlayer(std::uint32_t slot) {
  world_.erase(slot);
  players_[slot] = {};
  resetKeys();
}

void Game::restart(std::uint32_t slot) {
  PlayerState& player = players_[slot];
  player.startedAt = player.checkpoint = player.arrived = 0;
  player.checkpointUp = Angle();
  respawn(slot);
  resetKeys();
}

// The doors close again once no attempt is under way.
void Game::resetKeys() {
  const auto hasStarted = [](const PlayerState& player) { return player.startedAt != 0; };
  if (std::none_of(players_.begin(), players_.end(), hasStarted)) keys_ = 0;
}

// The insertion cannot fail: loadLevel has checked that the start and all checkpoints are free.
void Game::respawn(std::uint32_t slot) {
  PlayerState& player = players_[slot];
  player.velocity = player.ground = {};
  player.coyote = player.jumpBuffer = player.jumping = 0;
  world_.erase(slot);
  Entity entity(world_, slot);
  if (player.checkpoint == 0) {
    MapPart(world_, level_->startFace).insert(entity, level_->start, level_->startAngle);
    return;
  }
  const Element& checkpoint = level_->elements[player.checkpoint - 1U];
  MapPart(world_, checkpoint.face).insert(entity, placeOf(checkpoint), player.checkpointUp);
}

void Game::updateFinishes() {
  std::uint32_t finished = 0;
  for (std::uint32_t slot = 0; slot < players_.size(); ++slot) {
    PlayerState& player = players_[slot];
    if (player.present == 0) continue;
    if (player.arrived == 0 && touchesGoal(slot)) arrive(player);
    if (player.finished()) ++finished;
  }
  const std::uint32_t present = presentPlayers();
  if ((present != 0 && finished == present) || tick_ >= kRoundTicks) over_ = 1;
}

void Game::arrive(PlayerState& player) {
  if (player.startedAt == 0) player.startedAt = tick_;
  player.arrived = 1;
  const std::uint32_t ticks = tick_ - player.startedAt + 1;
  player.finishTicks = player.finished() ? std::min(player.finishTicks, ticks) : ticks;
}

bool Game::touchesGoal(std::uint32_t slot) const {
  const EntityState& entity = world_.entities()[slot];
  return std::any_of(level_->goalPlaces.begin(), level_->goalPlaces.end(), [&](const Place& goal) {
    return goal.part == entity.part && squaredLength(goal.position - entity.position) < kGoalReach * kGoalReach;
  });
}

// Visits the fields of the round by name, in the order in which they are hashed and saved.
template <class Self, class Visitor>
void Game::visitRound(Self& self, Visitor&& visitor) {
  visitor("tick", self.tick_);
  visitor("keys", self.keys_);
  visitor("plates", self.plates_);
  visitor("over", self.over_);
}

// Visits every field besides level and world.
template <class Self, class Visitor>
void Game::visit(Self& self, Visitor&& visitor) {
  visitRound(self, visitor);
  for (auto& player : self.players_) PlayerState::visit(player, visitor);
}

std::uint64_t Game::hash() const {
  Hash hash;
  hash.add(world_.hash());
  visitRound(*this, [&](const char*, const auto& field) { hash.add(field); });
  for (const PlayerState& player : players_) hash.add(hashOfRecord(player));
  return hash.value();
}

std::vector<std::uint8_t> Game::save() const {
  StateWriter writer;
  const auto write = [&](const char*, const auto& field) { writer.add(field); };
  const WorldState& state = world_.state();
  writer.add(static_cast<std::uint16_t>(players_.size()));
  for (const EntityState& entity : state.entities) EntityState::visit(entity, write);
  for (const InstanceState& instance : state.instances) InstanceState::visit(instance, write);
  visit(*this, write);
  return writer.take();
}

bool Game::restore(std::span<const std::uint8_t> bytes) {
  StateReader reader(bytes);
  const auto read = [&](const char*, auto& field) { reader.read(field); };
  std::uint16_t players = 0;
  reader.read(players);
  if (players > kMaxPlayers) return false;
  WorldState state;
  state.entities.resize(players);
  std::size_t instances = 0;
  for (EntityState& entity : state.entities) {
    EntityState::visit(entity, read);
    instances += entity.instances;
  }
  if (!reader.ok() || instances > reader.remaining()) return false;
  state.instances.resize(instances);
  for (InstanceState& instance : state.instances) InstanceState::visit(instance, read);
  Game restored(level_);
  restored.players_.resize(players);
  visit(restored, read);
  if (!reader.finished() || !restored.accepts(state)) return false;
  world_.restoreUnchecked(state);
  players_ = std::move(restored.players_);
  tick_ = restored.tick_;
  keys_ = restored.keys_;
  plates_ = restored.plates_;
  over_ = restored.over_;
  return true;
}

// True when `state` is valid for this level and fits players_. A turn that waits would remain when its player is put to
// the start, and turn its gravity there; no game asks for one.
bool Game::accepts(const WorldState& state) const {
  if (over_ > 1 || ((keys_ | plates_) & ~level_->doorNumbers) != 0 || !world_.accepts(state)) return false;
  for (std::size_t slot = 0; slot < players_.size(); ++slot) {
    const EntityState& entity = state.entities[slot];
    if (!accepts(players_[slot]) || players_[slot].present != entity.inserted || entity.turn != 0) return false;
  }
  return true;
}

bool Game::accepts(const PlayerState& player) const {
  const auto inRange = [](Point point, std::int32_t limit) {
    return std::abs(std::int64_t{point.x}) <= limit && std::abs(std::int64_t{point.y}) <= limit;
  };
  if (player.present == 0) return player == PlayerState();  // an attempt of nobody would keep the doors open
  if (player.present > 1 || player.arrived > 1 || player.jumping > 1) return false;
  if (player.startedAt > tick_ || player.finishTicks > tick_) return false;
  if (!inRange(player.velocity, kMaxPlayerSpeed) || !inRange(player.ground, PlayerState::kUnit)) return false;
  if (player.checkpoint == 0) return player.checkpointUp == Angle();
  return player.checkpoint <= level_->elements.size() && isCheckpoint(level_->elements[player.checkpoint - 1U].kind);
}

bool operator==(const Game& a, const Game& b) {
  return a.level_->hash == b.level_->hash && a.world_ == b.world_ && a.players_ == b.players_ && a.tick_ == b.tick_ &&
         a.keys_ == b.keys_ && a.plates_ == b.plates_ && a.over_ == b.over_;
}

}  // namespace platon
