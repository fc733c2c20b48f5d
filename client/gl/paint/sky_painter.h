#pragma once

#include <cstdint>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/palette.h"

namespace platon {

/// Draws the sky behind everything else: a gradient with a glow, and motes that drift round the solid.
class SkyPainter {
 public:
  SkyPainter();

  /// Paints the sky of pictures of this size, in pixels, if it is not the last one. Changes the bound framebuffer, so
  /// it comes before the picture is begun.
  void prepare(const Scheme& scheme, std::uint32_t width, std::uint32_t height);
  /// Copies the sky that was prepared over the whole picture.
  void drawSky() const;
  /// `radius` is that of the solid, level units; `seconds` the time of the animation.
  void drawMotes(const Scheme& scheme, const Camera& camera, double radius, double seconds);

 private:
  // What the sky depends on.
  struct Appearance {
    Colour top{0};
    Colour bottom{0};
    Colour glow{0};
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    friend bool operator==(const Appearance&, const Appearance&) = default;
  };

  ShaderProgram sky_;
  ShaderProgram motes_;
  GlVertexArray array_;  // empty: the shaders compute positions from gl_VertexID
  Appearance painted_;   // on the framebuffer
  GlFramebuffer framebuffer_;
  GlTexture colour_;
};

}  // namespace platon
