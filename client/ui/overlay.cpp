#include "client/ui/overlay.h"

#include <algorithm>

#include <glm/vec3.hpp>

namespace platon {
namespace {

constexpr float kDark = 0.2F;

float brightest(const glm::vec4& colour) { return std::max({colour.r, colour.g, colour.b}); }

void raise(Overlay::Text& text) {
  if (brightest(text.colour) < kDark) return;  // on a bright panel
  text.colour = glm::vec4(glm::vec3(text.colour) / brightest(text.colour), 1);
}

// A panel without any colour dims the picture behind it, as before.
void raise(Overlay::Panel& panel) {
  const bool dims = panel.high.y - panel.low.y >= Overlay::kHeight;
  if (dims) return;
  if (brightest(panel.colour) < kDark) panel.colour = glm::vec4(0, 0, 0, 1);
  panel.colour.a = 1;
}

}  // namespace

void raiseContrast(Overlay& overlay) {
  for (Overlay::Panel& panel : overlay.panels) raise(panel);
  for (Overlay::Text& text : overlay.texts) raise(text);
}

}  // namespace platon
