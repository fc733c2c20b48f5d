#pragma once

#include <cstdint>
#include <span>

#include "client/gl/background_painter.h"
#include "client/gl/ball_painter.h"
#include "client/gl/image.h"
#include "client/gl/overlay_painter.h"
#include "client/gl/render_target.h"
#include "client/gl/stage_painter.h"
#include "client/gl/text_painter.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// Draws scenes with OpenGL 3.3 core. The context must be current from construction to destruction.
class Renderer {
 public:
  static constexpr int kSamples = 4;

  /// The pictures have this size in pixels, at least 1 × 1. `font` must outlive the renderer. Throws
  /// std::runtime_error on an OpenGL error.
  Renderer(std::uint32_t width, std::uint32_t height, const Font& font);

  /// No effect if a size is 0 or both are unchanged.
  void resize(std::uint32_t width, std::uint32_t height);

  /// Draws the scene as `camera` sees it, then the overlays, in order. The camera must have the size of the picture.
  /// Without `animated`, decorations such as the goal's glow stand still.
  void draw(const Scene& scene, const Camera& camera, std::span<const Overlay> overlays, bool animated = true);

  /// Draws the background and the overlays.
  void drawEmpty(const Camera& camera, std::span<const Overlay> overlays);

  /// Copies the last picture to the window, which must have the same size.
  void present() const { target_.present(); }
  /// Returns the last picture.
  Image read() const { return target_.read(); }

 private:
  void drawOverlays(std::span<const Overlay> overlays);

  RenderTarget target_;
  StagePainter stagePainter_;
  BallPainter ballPainter_;
  TextPainter textPainter_;
  OverlayPainter overlayPainter_;
  BackgroundPainter backgroundPainter_;
};

}  // namespace platon
