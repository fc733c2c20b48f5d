#pragma once

#include <cstdint>

#include "client/gl/gl_handle.h"

namespace platon {

/// Makes `texture` a picture of this size in pixels, and what is drawn to the bound framebuffer. Between pixels it is
/// interpolated linearly.
void attachColour(const GlTexture& texture, std::uint32_t width, std::uint32_t height);

}  // namespace platon
