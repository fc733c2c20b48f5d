#pragma once

#include <cstdint>

namespace platon {

/// The frame that left and right refer to. The two frames differ while the camera rolls.
enum class ControlFrame : std::uint8_t { kPlayer, kScreen };

}  // namespace platon
