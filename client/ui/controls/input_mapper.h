#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "client/scene/camera_controls.h"
#include "client/ui/controls/bindings.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"
#include "platon/game/input.h"

namespace platon {

/// Controls of the game that are held during a tick. Directions are those of the keys, before Steering.
struct HeldKeys {
  bool left = false;
  bool right = false;
  bool up = false;
  bool down = false;
  bool jump = false;
  bool walk = false;   ///< two thirds of the run speed
  bool creep = false;  ///< one third
  bool restart = false;

  friend bool operator==(const HeldKeys&, const HeldKeys&) = default;
};

/// What a key does to the user interface.
enum class Action : std::uint8_t {
  kOpenMenu,
  kToggleHelp,
  kToggleNetGraph,
  kToggleFullscreen,
  kToggleVote,
  kGoOn,
  kJoin,  ///< another player joins with this device, or leaves
  kWatchNext,
  kSay,
  kEmote1,  ///< the emotes are in the order of their numbers
  kEmote2,
  kEmote3,
  kEmote4,
  kTakePicture
};

/// Decides what each key does: an action of the user interface, a control of the game, or both.
class InputMapper {
 public:
  /// From now on the controls have these keys. A toggled control that is on stays on.
  void configure(const Bindings& bindings, const ToggledControls& toggled);

  /// Returns the action of the event, if it has one. While the menu is open, a press is not passed to the game, and
  /// neither is the rest of that press after the menu has closed. Key repeat has no action.
  std::optional<Action> handle(const KeyEvent& event, bool menuOpen);

  /// Returns the controls of the next tick: the held ones, and those pressed since the last call even if they have
  /// been released again. While the player looks round by keys, the directions move the view, not the player. Called
  /// once a tick.
  HeldKeys takeHeld();

  /// All keys count as released.
  void release();

  /// How the player looks round: with its key and a direction, or with the right stick.
  LookInput look() const;

 private:
  std::optional<Action> press(const KeyEvent& event, bool menuOpen);
  bool looksByKeys() const;

  Bindings bindings_;
  ToggledControls toggled_;
  bool slow_ = false;  // toggled on, as the next one
  bool looking_ = false;
  std::bitset<kKeyCount> held_;                    // pressed while the menu was closed, not released yet
  std::array<std::uint8_t, kKeyCount> holders_{};  // on how many devices
  std::bitset<kKeyCount> pressed_;                 // since the last takeHeld
};

/// Turns held keys into the player's input.
class Steering {
 public:
  /// `roll` is Camera::rollOf(player). In ControlFrame::kScreen, the held directions keep their meaning until all of
  /// them are released; otherwise a player who runs over an edge would turn round.
  Input input(const HeldKeys& keys, double roll, ControlFrame frame);

 private:
  int quarters_ = 0;  // counter-clockwise quarter turns of the player on the screen when the held keys were pressed
};

/// Looks round the solid while the right button of the mouse is held: the solid follows the pointer.
class MouseLook {
 public:
  static constexpr double kTurn = 0.006;  ///< radians a unit of the virtual screen, which is 720 high

  void handle(const PointerEvent& event);
  /// The button counts as released until it is pressed again.
  void release();

  /// How the player looks round since the last call, with what keys and gamepad do.
  LookInput take(LookInput others);

 private:
  bool held_ = false;
  glm::dvec2 place_{0};  // of the pointer
  glm::dvec2 turn_{0};   // since the last `take`
};

}  // namespace platon
