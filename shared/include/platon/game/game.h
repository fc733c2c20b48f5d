#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "platon/game/element.h"
#include "platon/game/input.h"
#include "platon/game/level.h"
#include "platon/game/player.h"
#include "platon/game/unit_normals.h"
#include "platon/physics/world.h"

namespace platon {

inline constexpr int kTicksPerSecond = 60;
inline constexpr std::uint32_t kMaxPlayers = 256;
/// Longest round: five minutes.
inline constexpr std::uint32_t kRoundTicks = 5 * 60 * kTicksPerSecond;
/// Version of the game's rules. Raised by a change after which the same inputs give other hashes, as the
/// section "Versions" of docs/architecture.md says.
inline constexpr std::uint32_t kRulesVersion = 8;

/// One round on one level: the world, the players, the goal and the round clock. A copy is an independent game.
class Game {
 public:
  explicit Game(std::shared_ptr<const Level> level);

  /// Advances the game by one tick. `inputs` holds one input per slot, at most kMaxPlayers; a slot beyond its end has
  /// no player. Server, prediction, replay and tests all call this function; nothing else advances a game.
  void advance(std::span<const Input> inputs, StepObserver* observer = nullptr);

  const Level& level() const { return *level_; }
  const std::shared_ptr<const Level>& sharedLevel() const { return level_; }
  const World& world() const { return world_; }

  /// Ticks advanced so far.
  std::uint32_t tick() const { return tick_; }
  /// Ticks until the time is up.
  std::uint32_t ticksLeft() const;
  /// True once all players present, at least one, have finished, or the time is up. Players can still move.
  bool over() const { return over_ != 0; }

  /// Number of players who are present.
  std::uint32_t presentPlayers() const;
  /// Number of slots used so far. The slot is also the index of the player's entity in the world.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(players_.size()); }
  /// slot < slots().
  const PlayerState& player(std::uint32_t slot) const { return players_[slot]; }

  /// Bits of the numbers whose doors are open in the next tick: a key was taken, or a player stands on a plate.
  std::uint32_t openDoors() const { return keys_ | plates_; }
  /// What is open in the next tick.
  OpenElements open() const { return {openDoors(), tick_}; }
  /// Bits of the numbers whose keys have been taken.
  std::uint32_t takenKeys() const { return keys_; }
  /// Bits of the numbers on whose plates a player stood after the last tick.
  std::uint32_t pressedPlates() const { return plates_; }
  /// Whether the key has been taken.
  bool isTaken(const Element& key) const { return (keys_ & key.bit()) != 0; }

  /// Hash of the whole state; the same on every machine.
  std::uint64_t hash() const;
  /// The whole state as bytes, little-endian, without the level and without derived data.
  std::vector<std::uint8_t> save() const;
  /// Restores a state saved on the same level. Returns false and leaves the game unchanged when `bytes` is not a valid
  /// state.
  bool restore(std::span<const std::uint8_t> bytes);

  friend bool operator==(const Game& a, const Game& b);

 private:
  void addAndRemovePlayers(std::span<const Input> inputs);
  void addPlayer(std::uint32_t slot);
  void removePlayer(std::uint32_t slot);
  void steer(std::uint32_t slot, Input input);
  std::uint32_t startOfAttempt() const;
  void restart(std::uint32_t slot);
  void resetKeys();
  void respawn(std::uint32_t slot);
  void updateFinishes();
  void arrive(PlayerState& player);
  bool touchesGoal(std::uint32_t slot) const;
  bool accepts(const WorldState& state) const;
  bool accepts(const PlayerState& player) const;
  template <class Self, class Visitor>
  static void visitRound(Self& self, Visitor&& visitor);
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor);

  std::shared_ptr<const Level> level_;
  World world_;
  std::vector<PlayerState> players_;
  std::uint32_t tick_ = 0;
  std::uint32_t keys_ = 0;    // bits of the keys that have been taken
  std::uint32_t plates_ = 0;  // bits of the plates on which a player stood after the last tick
  std::uint8_t over_ = 0;
  UnitNormals unitNormals_;  // derived
  TouchedElements touched_;  // work space of a tick
};

}  // namespace platon
