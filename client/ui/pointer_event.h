#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace platon {

/// A movement of the mouse, a change of one of its buttons, or a turn of its wheel.
struct PointerEvent {
  enum class Kind : std::uint8_t { kMove, kPress, kRelease, kScroll };
  enum class Button : std::uint8_t { kLeft, kRight, kMiddle };

  Kind kind = Kind::kMove;
  glm::dvec2 place{0};            ///< on the virtual screen of an Overlay: 720 high, +y down
  Button button = Button::kLeft;  ///< of kPress and kRelease
  double scroll = 0;              ///< of kScroll: notches, away from the user is positive
  bool alt = false;               ///< Alt was held
  bool shift = false;             ///< Shift was held

  friend bool operator==(const PointerEvent&, const PointerEvent&) = default;
};

}  // namespace platon
