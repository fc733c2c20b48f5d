#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "client/gl/game_view.h"
#include "client/gl/window.h"
#include "protocol/moment.h"

namespace platon {

/// Size of the program's pictures: off-screen in pixels, of a new window in screen coordinates.
inline constexpr std::uint32_t kPictureWidth = 1280;
inline constexpr std::uint32_t kPictureHeight = 720;

/// Shortest time of a picture, for drivers that do not wait for the vertical blank.
inline constexpr Moment kMinFrameTime = std::chrono::milliseconds(2);

/// Least time from one picture to the next while the player does not look at a game that runs.
inline constexpr Moment kCalmFrameTime = std::chrono::microseconds(33'333);

/// Least time from one picture to the next: kCalmFrameTime in a `calm` window, else that of `frameCap` pictures a
/// second (Settings::frameCap), but at least kMinFrameTime.
Moment frameTimeOf(bool calm, double frameCap);

/// Opens the window of the program. Throws ProgramError if there is none. Without a display its text ends with
/// `otherwise`, which says what can be done without a window.
Window openWindow(const std::string& otherwise);

/// Says in the window that the program is loading, until the next picture.
void showLoading(Window& window, GameView& view);

}  // namespace platon
