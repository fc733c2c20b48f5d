#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace platon {

/// What the player does in a game by keys that can be chosen.
enum class Control : std::uint8_t {
  kLeft,
  kRight,
  kUp,  ///< jumps; with controls relative to the screen, moves upwards on it
  kDown,
  kJump,
  kSlow,
  kRestart,
  kVote,
  kLook,
  kWatch,
  kSay
};
inline constexpr std::size_t kControlCount = static_cast<std::size_t>(Control::kSay) + 1;

/// What the control does, for the player.
std::string_view nameOf(Control control);
/// The name of the control in the settings file.
std::string_view wordOf(Control control);
/// The control with this name in the settings file.
std::optional<Control> controlNamed(std::string_view word);

}  // namespace platon
