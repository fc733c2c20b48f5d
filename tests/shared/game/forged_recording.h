#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/recorder.h"
#include "platon/game/state_bytes.h"
#include "shared/exact/hash.h"

namespace platon {

/// A recording with correct checksums and blocks that no Recorder would write.
class ForgedRecording {
 public:
  explicit ForgedRecording(const Game& start) : state_(start.save()), bytes_(Recorder(start).takeBytes()) {}

  /// Sets the state of the blocks added from now on.
  void setState(std::vector<std::uint8_t> state) { state_ = std::move(state); }
  /// Adds a block. `runsAndHashes` is what follows the state in its body.
  void addBlock(std::uint32_t first, std::uint16_t ticks, std::uint16_t slots,
                const std::vector<std::uint8_t>& runsAndHashes) {
    StateWriter body;
    body.add(first);
    body.add(ticks);
    body.add(slots);
    body.add(static_cast<std::uint32_t>(state_.size()));
    body.append(state_);
    body.append(runsAndHashes);
    addBody(body.bytes());
  }
  /// Adds a block with any body.
  void addBody(std::span<const std::uint8_t> body) {
    StateWriter block;
    block.add(static_cast<std::uint32_t>(body.size()));
    block.add(~static_cast<std::uint32_t>(body.size()));
    block.append(body);
    block.add(hashOf(body));
    bytes_.insert(bytes_.end(), block.bytes().begin(), block.bytes().end());
  }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> state_;
  std::vector<std::uint8_t> bytes_;
};

/// The state of a game, to be changed at will.
class ForgedState {
 public:
  explicit ForgedState(const Game& game) : game_(game) {
    StateReader reader(bytes_ = game.save());
    std::uint16_t count = 0;
    reader.read(count);
    entities.resize(count);
    players.resize(count);
    const auto read = [&](const char*, auto& field) { reader.read(field); };
    std::size_t further = 0;
    for (EntityState& entity : entities) {
      EntityState::visit(entity, read);
      further += entity.instances;
    }
    instances.resize(further);
    for (InstanceState& instance : instances) InstanceState::visit(instance, read);
    for (std::uint32_t* const field : {&tick, &keys, &plates}) reader.read(*field);
    reader.read(over_);
    for (PlayerState& player : players) PlayerState::visit(player, read);
  }

  /// The game in this state. Throws std::invalid_argument if the level does not allow it.
  Game game() const {
    StateWriter writer;
    const auto write = [&](const char*, const auto& field) { writer.add(field); };
    writer.add(static_cast<std::uint16_t>(players.size()));
    for (const EntityState& entity : entities) EntityState::visit(entity, write);
    for (const InstanceState& instance : instances) InstanceState::visit(instance, write);
    for (const std::uint32_t field : {tick, keys, plates}) writer.add(field);
    writer.add(over_);
    for (const PlayerState& player : players) PlayerState::visit(player, write);
    Game forged = game_;
    if (!forged.restore(writer.bytes())) throw std::invalid_argument("the level does not allow the state");
    return forged;
  }

  std::vector<EntityState> entities;
  std::vector<InstanceState> instances;  ///< further ones, by entity
  std::vector<PlayerState> players;
  std::uint32_t tick = 0;
  std::uint32_t keys = 0;
  std::uint32_t plates = 0;

 private:
  Game game_;
  std::vector<std::uint8_t> bytes_;
  std::uint8_t over_ = 0;
};

/// Records the player of slot 0 as it runs to the right from `start`, until it touches the goal.
inline std::vector<std::uint8_t> recordToGoal(const Game& start) {
  const Input right{Input::kPresent | Input::kRight};
  Game game = start;
  Recorder recorder(game);
  for (int tick = 0; tick < 400 && (game.slots() == 0 || game.player(0).arrived == 0); ++tick) {
    game.advance({&right, 1});
    recorder.record({&right, 1}, game);
  }
  recorder.finish(game);
  return recorder.takeBytes();
}

/// As recordToGoal, but the player, who rests at the start of the level, has been put to this x, subunits.
inline std::vector<std::uint8_t> forgedRun(const std::shared_ptr<const Level>& level, std::int32_t x) {
  Game game(level);
  const Input rest{Input::kPresent};
  for (int tick = 0; tick < 60; ++tick) game.advance({&rest, 1});
  ForgedState state(game);
  state.entities[0].position.x = x;
  return recordToGoal(state.game());
}

}  // namespace platon
