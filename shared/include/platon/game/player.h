#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/input.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity.h"

namespace platon {

/// All of a player that is saved and hashed besides its entity. Vectors are in the player's own frame (+y is the
/// player's up), so that walking over an edge never rounds them.
struct PlayerState {
  /// A unit vector in the own frame has this length.
  static constexpr std::int32_t kUnit = 1 << 14;

  Point velocity;                ///< subunits a tick
  Point ground;                  ///< unit normal of the ground stood on; (0, 0) in the air
  std::uint32_t finishedAt = 0;  ///< tick of the finish
  std::uint8_t present = 0;
  std::uint8_t finished = 0;    ///< has touched the goal this round
  std::uint8_t held = 0;        ///< buttons of the last tick
  std::uint8_t coyote = 0;      ///< ticks left in which a jump still counts as from the ground
  std::uint8_t jumpBuffer = 0;  ///< ticks left in which a pressed jump waits for the ground
  std::uint8_t rising = 0;      ///< in a jump that ends early when the button is let go

  friend bool operator==(const PlayerState&, const PlayerState&) = default;

  /// Every field by name, in the order in which it is hashed and saved.
  template <class State, class Visitor>
  static void visit(State& state, Visitor&& visitor) {
    visitor("velocity", state.velocity);
    visitor("ground", state.ground);
    visitor("finishedAt", state.finishedAt);
    visitor("present", state.present);
    visitor("finished", state.finished);
    visitor("held", state.held);
    visitor("coyote", state.coyote);
    visitor("jumpBuffer", state.jumpBuffer);
    visitor("rising", state.rising);
  }
};

/// The player's radius in subunits.
inline constexpr std::int32_t kPlayerRadius = 12 * 1024;

/// The player's figure: a ball, for the world a regular 16-gon with an edge at the bottom.
Convex playerShape();

/// A player of the game: an entity that buttons move. A handle like Entity.
class Player : public Entity {
 public:
  Player(World& world, std::uint32_t slot, PlayerState& state) : Entity(world, slot), state_(&state) {}

  /// Processes the buttons and updates the velocity, before the world is solved.
  void tick(Input input);
  /// Takes out of the velocity what a line stops, and remembers the ground; called while the world is solved. `normal`
  /// is the line's, a unit vector in the own frame. `steep`, (0, 0) at the start of each tick, keeps that of the last
  /// line that was too steep to be ground.
  void contact(Point normal, Point& steep);

  /// The player's up in the frame of its face is +y turned by this.
  Angle up() const { return rotation(); }

 private:
  void run(Input input);
  void jump(Input input);
  void fall();
  void holdBetween(Point normal, Point& steep);

  PlayerState* state_;
};

}  // namespace platon
