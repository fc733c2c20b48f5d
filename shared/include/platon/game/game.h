#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "platon/game/input.h"
#include "platon/game/level.h"
#include "platon/game/player.h"
#include "platon/game/unit_normals.h"
#include "platon/physics/sweep.h"
#include "platon/physics/world.h"

namespace platon {

inline constexpr int kTicksPerSecond = 60;
inline constexpr std::uint32_t kMaxPlayers = 256;
/// Longest round: five minutes.
inline constexpr std::uint32_t kRoundTicks = 5 * 60 * kTicksPerSecond;
/// Version of the game's rules. Must be raised with every change after which the same inputs give other hashes.
inline constexpr std::uint32_t kRulesVersion = 6;

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

  /// Number of slots used so far. The slot is also the index of the player's entity in the world.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(players_.size()); }
  /// slot < slots().
  const PlayerState& player(std::uint32_t slot) const { return players_[slot]; }

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
  void spawn(std::uint32_t slot);
  void removePlayer(std::uint32_t slot);
  void updateFinishes();
  bool touchesGoal(std::uint32_t slot);
  bool containsGoal(std::uint32_t slot, Point position, Angle angle);
  bool accepts(const WorldState& state) const;
  template <class Self, class Visitor>
  static void visitRound(Self& self, Visitor&& visitor);
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor);

  std::shared_ptr<const Level> level_;
  World world_;
  std::vector<PlayerState> players_;
  std::uint32_t tick_ = 0;
  std::uint8_t over_ = 0;
  UnitNormals unitNormals_;  // derived
  Sweep goalSweep_;          // derived: buffer for containsGoal
};

}  // namespace platon
