#pragma once

#include "levels/picture/canvas.h"
#include "platon/game/level.h"

namespace platon {

/// Width of a picture of a level, pixels. The height is 5/8 of it.
inline constexpr int kMinPictureWidth = 160;
inline constexpr int kMaxPictureWidth = Canvas::kMaxSize;
inline constexpr int kPictureWidth = 1600;

/// Draws a level: its title, its solid from two opposite sides, and its net, with the same tint for a face in both.
/// docs/level_format.md explains the picture. `width` is between the limits above.
Canvas drawLevel(const Level& level, int width);

}  // namespace platon
