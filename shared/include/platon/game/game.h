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
/// A round lasts this long at most: five minutes.
inline constexpr std::uint32_t kRoundTicks = 5 * 60 * kTicksPerSecond;
/// Changes whenever the same inputs could give another game.
inline constexpr std::uint32_t kRulesVersion = 3;

/// One round on one level: World, players, goal and round clock. A value: copying it gives an independent game.
class Game {
 public:
  explicit Game(std::shared_ptr<const Level> level);

  /// Moves the game by one tick; `inputs` by slot, at most kMaxPlayers, slots beyond its end are absent. The only
  /// thing that does: server, prediction, replay and tests all call it.
  void advance(std::span<const Input> inputs, StepObserver* observer = nullptr);

  const Level& level() const { return *level_; }
  const std::shared_ptr<const Level>& sharedLevel() const { return level_; }
  const World& world() const { return world_; }

  /// Ticks advanced so far.
  std::uint32_t tick() const { return tick_; }
  /// Ticks until time is up.
  std::uint32_t ticksLeft() const;
  /// All present players, at least one, have finished, or time is up. Players may go on moving.
  bool over() const { return over_ != 0; }

  /// Slots that have ever been used; slot == index of the player's entity in the world.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(players_.size()); }
  /// slot < slots().
  const PlayerState& player(std::uint32_t slot) const { return players_[slot]; }

  /// Of everything that decides the future; the same on every machine.
  std::uint64_t hash() const;
  /// All basic state as bytes, little-endian, without the level.
  std::vector<std::uint8_t> save() const;
  /// False, and the game unchanged, when `bytes` is not a state that `save` could have given for this level.
  bool restore(std::span<const std::uint8_t> bytes);

  friend bool operator==(const Game& a, const Game& b);

 private:
  void admit(std::span<const Input> inputs);
  void enter(std::uint32_t slot);
  void spawn(std::uint32_t slot);
  void leave(std::uint32_t slot);
  void judge();
  bool touchesGoal(std::uint32_t slot);
  bool coversGoal(std::uint32_t slot, Point position, Angle angle);
  bool accepts(const WorldState& state) const;
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor);

  std::shared_ptr<const Level> level_;
  World world_;
  std::vector<PlayerState> players_;
  std::uint32_t tick_ = 0;
  std::uint8_t over_ = 0;
  UnitNormals unitNormals_;  // derived
  Sweep goalSweep_;          // room for work
};

}  // namespace platon
