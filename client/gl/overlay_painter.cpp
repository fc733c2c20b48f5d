#include "client/gl/overlay_painter.h"

#include <cstddef>

#include <glm/gtc/matrix_transform.hpp>

namespace platon {

OverlayPainter::OverlayPainter() : program_("panel") {
  stream_.attribute(0, 2, offsetof(Vertex, place));
  stream_.attribute(1, 2, offsetof(Vertex, fromMiddle));
  stream_.attribute(2, 3, offsetof(Vertex, form));
  stream_.attribute(3, 4, offsetof(Vertex, colour));
}

void OverlayPainter::draw(const Overlay& overlay, float aspect, TextPainter& text) {
  const glm::mat4 toClip = glm::ortho(0.0F, Overlay::kHeight * aspect, Overlay::kHeight, 0.0F);
  drawPanels(overlay, toClip);
  for (const Overlay::Text& line : overlay.texts) {
    text.add(line.content, line.place, {line.size, 0}, {0, -line.size}, line.colour);
  }
  text.flush(toClip, 0.55F);
}

void OverlayPainter::add(const Overlay::Panel& panel) {
  const glm::vec2 middle = (panel.low + panel.high) / 2.0F;
  const glm::vec2 half = (panel.high - panel.low) / 2.0F;
  const glm::vec2 signs[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
  for (const glm::vec2 sign : signs) {
    // One unit larger on each side, for the anti-aliased edge.
    const glm::vec2 away = sign * (half + 1.0F);
    vertices_.push_back({middle + away, away, glm::vec3(half, panel.radius), panel.colour});
  }
}

void OverlayPainter::drawPanels(const Overlay& overlay, const glm::mat4& toClip) {
  vertices_.clear();
  for (const Overlay::Panel& panel : overlay.panels) add(panel);
  if (vertices_.empty()) return;
  program_.use();
  program_.set("toClip", toClip);
  stream_.drawTriangles(vertices_);
}

}  // namespace platon
