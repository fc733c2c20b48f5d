#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace platon {

/// A movement of the mouse, a change of one of its buttons, or a turn of its wheel.
struct PointerEvent {
  enum class Kind : std::uint8_t { kMove, kPress, kRelease, kScroll };
  /// kBack: the button at the side that goes back.
  enum class Button : std::uint8_t { kLeft, kRight, kMiddle, kBack };

  Kind kind = Kind::kMove;
  glm::dvec2 place{0};            ///< on the virtual screen of an Overlay: 720 high, +y down
  Button button = Button::kLeft;  ///< of kPress and kRelease
  double scroll = 0;              ///< of kScroll: notches, away from the user is positive
  bool alt = false;               ///< Alt was held
  bool shift = false;             ///< Shift was held

  friend bool operator==(const PointerEvent&, const PointerEvent&) = default;
};

/// Whether the event goes back, in menus and replays: a press of the right button or of the one at the side.
constexpr bool goesBack(const PointerEvent& event) {
  using Button = PointerEvent::Button;
  return event.kind == PointerEvent::Kind::kPress && (event.button == Button::kRight || event.button == Button::kBack);
}

}  // namespace platon
