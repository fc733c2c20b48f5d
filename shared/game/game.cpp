#include "platon/game/game.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "platon/game/state_bytes.h"
#include "platon/physics/map_part.h"
#include "platon/physics/rules.h"
#include "shared/exact/hash.h"

namespace platon {
namespace {

// The rules of the world while it exists. Passes each contact to the player that has it.
class GameRules : public Rules {
 public:
  GameRules(World& world, std::vector<PlayerState>& players, UnitNormals& unitNormals)
      : world_(world), players_(players), unitNormals_(unitNormals) {
    world_.setRules(*this);
  }
  GameRules(const GameRules&) = delete;
  GameRules& operator=(const GameRules&) = delete;
  ~GameRules() override { world_.resetRules(); }

  bool ignoresWarps() const override { return true; }
  void contact(Entity& entity, const Contact& contact) override {
    if (entity.index() != moved_) steep_ = Point();
    moved_ = entity.index();
    Player player(world_, moved_, players_[moved_]);
    player.contact(unitNormals_.of(contact.normal, contact.segment.toHome - player.up()), steep_);
  }

 private:
  World& world_;
  std::vector<PlayerState>& players_;
  UnitNormals& unitNormals_;
  std::uint32_t moved_ = ~std::uint32_t{0};  // slot of the last contact: those of one entity follow each other
  Point steep_;                              // normal of its last contact that was too steep to be ground
};

}  // namespace

Game::Game(std::shared_ptr<const Level> level) : level_(std::move(level)), world_(level_->world) {
  world_.addShape(playerShape());
}

void Game::advance(std::span<const Input> inputs, StepObserver* observer) {
  assert(inputs.size() <= kMaxPlayers);
  const GameRules rules(world_, players_, unitNormals_);
  addAndRemovePlayers(inputs);
  for (std::uint32_t slot = 0; slot < players_.size(); ++slot) {
    if (players_[slot].present == 0) continue;
    const Input input = inputs[slot];
    const bool restart = input.has(Input::kRestart) && (players_[slot].held & Input::kRestart) == 0;
    if (restart) spawn(slot);
    Player(world_, slot, players_[slot]).tick(input);
  }
  world_.solve(observer);
  ++tick_;
  updateFinishes();
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
    Entity(world_, playerShape());
    players_.emplace_back();
  }
  players_[slot] = {};
  players_[slot].present = 1;
  spawn(slot);
}

// The insertion cannot fail: loadLevel has checked that the start is free.
void Game::spawn(std::uint32_t slot) {
  PlayerState& player = players_[slot];
  player.velocity = player.ground = {};
  player.coyote = player.jumpBuffer = player.rising = 0;
  world_.remove(slot);
  Entity entity(world_, slot);
  MapPart(world_, level_->startFace).insert(entity, level_->start, level_->startAngle);
}

void Game::removePlayer(std::uint32_t slot) {
  world_.remove(slot);
  players_[slot] = {};
}

void Game::updateFinishes() {
  std::uint32_t present = 0;
  std::uint32_t finished = 0;
  for (std::uint32_t slot = 0; slot < players_.size(); ++slot) {
    PlayerState& player = players_[slot];
    if (player.present == 0) continue;
    ++present;
    if (player.finished == 0 && touchesGoal(slot)) {
      player.finished = 1;
      player.finishedAt = tick_;
    }
    finished += player.finished;
  }
  if ((present != 0 && finished == present) || tick_ >= kRoundTicks) over_ = 1;
}

// Checks every instance, because the goal may lie just behind an edge.
bool Game::touchesGoal(std::uint32_t slot) {
  const EntityState& entity = world_.entities()[slot];
  if (entity.part == level_->goalFace && containsGoal(slot, entity.position, entity.angle)) return true;
  if (entity.instances == 0) return false;
  const auto instances = world_.instancesOf(slot);
  return std::any_of(instances.begin(), instances.end(), [&](const InstanceState& instance) {
    return instance.part == level_->goalFace && containsGoal(slot, world_.positionOf(slot, instance), instance.angle);
  });
}

bool Game::containsGoal(std::uint32_t slot, Point position, Angle angle) {
  const Point distance = level_->goal - position;
  constexpr std::int32_t reach = kPlayerRadius + 1;  // vertices are rounded
  if (squaredLength(distance) > squaredLength(Point(reach, 0))) return false;
  const Convex* shape = world_.rotatedShapeOf(slot, angle);
  goalSweep_.start(*shape, position, {});
  return goalSweep_.against({level_->goal, level_->goal}).has_value();
}

// Visits the fields of the round by name, in the order in which they are hashed and saved.
template <class Self, class Visitor>
void Game::visitRound(Self& self, Visitor&& visitor) {
  visitor("tick", self.tick_);
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
  const WorldState& state = world_.save();
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
  over_ = restored.over_;
  return true;
}

// True when `state` is valid for this level and fits players_.
bool Game::accepts(const WorldState& state) const {
  if (over_ > 1 || !world_.accepts(state)) return false;
  for (std::size_t slot = 0; slot < players_.size(); ++slot) {
    const PlayerState& player = players_[slot];
    const auto inRange = [](Point point, std::int32_t limit) {
      return std::abs(std::int64_t{point.x}) <= limit && std::abs(std::int64_t{point.y}) <= limit;
    };
    if (player.present > 1 || player.finished > 1 || player.rising > 1) return false;
    if (!inRange(player.velocity, kMaxPlayerSpeed) || !inRange(player.ground, PlayerState::kUnit)) return false;
    if (player.present != state.entities[slot].inserted) return false;
  }
  return true;
}

bool operator==(const Game& a, const Game& b) {
  return a.level_->hash == b.level_->hash && a.world_ == b.world_ && a.players_ == b.players_ && a.tick_ == b.tick_ &&
         a.over_ == b.over_;
}

}  // namespace platon
