#pragma once

#include <cstdint>
#include <span>

#include "client/background_painter.h"
#include "client/ball_painter.h"
#include "client/camera.h"
#include "client/font.h"
#include "client/image.h"
#include "client/overlay.h"
#include "client/overlay_painter.h"
#include "client/render_target.h"
#include "client/scene.h"
#include "client/stage_painter.h"
#include "client/text_painter.h"

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
