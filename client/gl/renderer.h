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

/// Draws scenes with OpenGL 3.3 core, in the context that is current from its construction to its destruction.
class Renderer {
 public:
  static constexpr int kSamples = 4;

  /// Of pictures of this size in pixels, at least 1 × 1. Throws std::runtime_error when OpenGL refuses something.
  /// `font` outlives it.
  Renderer(std::uint32_t width, std::uint32_t height, const Font& font);

  /// Keeps the picture's old size when the new one is 0 or no other.
  void resize(std::uint32_t width, std::uint32_t height);

  /// Draws the scene as `camera`, which has been told the same size, sees it; then the overlays, in order. Without
  /// `animated`, nothing moves that the players do not move.
  void draw(const Scene& scene, const Camera& camera, std::span<const Overlay> overlays, bool animated = true);

  /// The same without a game: overlays on the dark.
  void drawEmpty(const Camera& camera, std::span<const Overlay> overlays);

  /// Copies the last picture to the window, which has the same size.
  void present() const { target_.present(); }
  /// The last picture.
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
