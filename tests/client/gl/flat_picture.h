#pragma once

#include <cstdint>
#include <span>

#include "client/gl/overlay_painter.h"
#include "client/gl/render_target.h"
#include "client/gl/text_painter.h"

namespace platon {

/// Overlays on a plain ground, so that a change of the scene does not change the picture. Needs a current context.
inline Image flatPicture(std::uint32_t width, std::uint32_t height, const Font& font,
                         std::span<const Overlay> overlays) {
  const RenderTarget target(width, height, 1);
  TextPainter text(font);
  OverlayPainter painter;
  target.bindSampled();
  glClearColor(0.30F, 0.36F, 0.44F, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  target.resolve();
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const Overlay& overlay : overlays)
    painter.draw(overlay, static_cast<float>(width) / static_cast<float>(height), text);
  return target.read();
}

}  // namespace platon
