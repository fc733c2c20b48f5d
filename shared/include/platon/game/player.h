#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/input.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity.h"

namespace platon {

/// State of a player besides its entity; all of it is saved and hashed. Vectors are in the player's own frame, whose +y
/// is the player's up, so that crossing an edge never rounds them.
struct PlayerState {
  /// Length of a unit vector in the own frame.
  static constexpr std::int32_t kUnit = 1 << 14;

  Point velocity;                 ///< subunits per tick
  Point ground;                   ///< unit normal of the ground; (0, 0) in the air
  std::uint32_t startedAt = 0;    ///< tick of the first input of this attempt, from 1; 0: none so far
  std::uint32_t finishTicks = 0;  ///< shortest time of an attempt to the goal in this round, in ticks; 0: not finished
  Angle checkpointUp;            ///< from the +y of the checkpoint's face to the player's up; zero without a checkpoint
  std::uint16_t checkpoint = 0;  ///< where the player returns to: 1 + index into Level::elements; 0: the start
  std::uint8_t present = 0;      ///< 1: the slot has a player
  std::uint8_t arrived = 0;      ///< 1: the player has touched the goal in this attempt
  std::uint8_t held = 0;         ///< buttons of the last tick
  std::uint8_t coyote = 0;       ///< ticks left in which the player may still jump after leaving the ground
  std::uint8_t jumpBuffer = 0;   ///< ticks left in which a jump pressed in the air starts on landing
  std::uint8_t jumping = 0;      ///< 1: in a jump whose button has been held since; releasing it cuts the rise short

  /// Whether the player has touched the goal in this round.
  bool finished() const { return finishTicks != 0; }

  friend bool operator==(const PlayerState&, const PlayerState&) = default;

  /// Visits every field by name, in the order in which they are hashed and saved.
  template <class State, class Visitor>
  static void visit(State& state, Visitor&& visitor) {
    visitor("velocity", state.velocity);
    visitor("ground", state.ground);
    visitor("startedAt", state.startedAt);
    visitor("finishTicks", state.finishTicks);
    visitor("checkpointUp", state.checkpointUp);
    visitor("checkpoint", state.checkpoint);
    visitor("present", state.present);
    visitor("arrived", state.arrived);
    visitor("held", state.held);
    visitor("coyote", state.coyote);
    visitor("jumpBuffer", state.jumpBuffer);
    visitor("jumping", state.jumping);
  }
};

/// Radius of the player in subunits, to the vertices of its shape.
inline constexpr std::int32_t kPlayerRadius = 12 * 1024;

/// Largest coordinate of a player's velocity in a valid state, subunits a tick. Falls, slopes and jumps together reach
/// less than two thirds of it on any level.
inline constexpr std::int32_t kMaxPlayerSpeed = 1 << 15;

/// Distance from the centre of the player to the edges of its shape, in subunits.
inline constexpr std::int32_t kPlayerApothem = 12052;

/// Shape of the player, which is drawn as a ball: a regular 16-gon with a horizontal edge at the bottom.
Convex playerShape();

/// An entity moved by buttons. A handle, as Entity is: it owns neither the entity nor the state.
class Player : public Entity {
 public:
  Player(World& world, std::uint32_t slot, PlayerState& state) : Entity(world, slot), state_(&state) {}

  /// Updates the velocity by the buttons of one tick. Called before World::solve.
  void tick(Input input);
  /// Removes the component of the velocity that points into a segment, and sets the ground. Called during World::solve.
  /// `normal` is the segment's unit normal in the own frame; `atEnd`: the player touches an end of it, not its side.
  /// `steep` keeps, from one contact to the next, the normal of the last segment that was too steep to be ground; the
  /// caller sets it to (0, 0) at the start of each tick.
  void contact(Point normal, bool atEnd, Point& steep);

  /// Whether a contact with this normal, a unit vector in the own frame, carries the player.
  static bool isGround(Point normal);

  /// Rotation from the face's +y to the player's up.
  Angle up() const { return rotation(); }

 private:
  void run(Input input);
  void jump(Input input);
  void fall();
  void limitClimb(std::int32_t upwards);
  void standInWedge(Point normal, Point& steep);

  PlayerState* state_;
};

}  // namespace platon
