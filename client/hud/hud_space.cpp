#include "client/hud/hud_space.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace platon {
namespace {

constexpr float kDescent = 0.3F;  // of a text below its baseline, at size 1

bool isEmpty(const Overlay& part) { return part.panels.empty() && part.texts.empty(); }

}  // namespace

HudBox boundsOf(const Overlay& part, const Font& font) {
  HudBox box{glm::vec2(std::numeric_limits<float>::max()), glm::vec2(std::numeric_limits<float>::lowest())};
  const auto include = [&box](glm::vec2 low, glm::vec2 high) {
    box.low = glm::min(box.low, low);
    box.high = glm::max(box.high, high);
  };
  for (const Overlay::Panel& panel : part.panels) include(panel.low, panel.high);
  for (const Overlay::Text& text : part.texts) {
    include(text.place - glm::vec2(0, text.size),
            text.place + glm::vec2(font.width(text.content) * text.size, kDescent * text.size));
  }
  return box;
}

Overlay movedBy(Overlay part, glm::vec2 offset) {
  for (Overlay::Panel& panel : part.panels) {
    panel.low += offset;
    panel.high += offset;
  }
  for (Overlay::Text& text : part.texts) text.place += offset;
  return part;
}

void HudSpace::reserveFoot(float height) {
  if (height > 0) taken_.push_back({{0, screen_.y - height}, screen_});
}

bool HudSpace::fits(const Overlay& part) const {
  if (isEmpty(part)) return true;
  const HudBox box = boundsOf(part, *font_);
  const bool inside = box.low.x >= 0 && box.low.y >= 0 && box.high.x <= screen_.x && box.high.y <= screen_.y;
  return inside && std::none_of(taken_.begin(), taken_.end(), [&](const HudBox& other) { return box.overlaps(other); });
}

bool HudSpace::add(const Overlay& part) {
  if (!fits(part)) return false;
  if (isEmpty(part)) return true;
  taken_.push_back(boundsOf(part, *font_));
  append(part);
  return true;
}

void HudSpace::addOver(const Overlay& part) {
  if (fits(part)) append(part);
}

void HudSpace::append(const Overlay& part) {
  overlay_.panels.insert(overlay_.panels.end(), part.panels.begin(), part.panels.end());
  overlay_.texts.insert(overlay_.texts.end(), part.texts.begin(), part.texts.end());
}

float HudSpace::endOfColumn(bool right) const {
  float end = 0;
  for (const HudBox& box : taken_) {
    const bool foot = box.low.y > screen_.y / 2;
    const bool inColumn = right ? box.high.x > screen_.x / 2 : box.low.x < screen_.x / 2;
    if (inColumn && !foot) end = std::max(end, box.high.y);
  }
  return end;
}

float HudSpace::startOfFoot() const {
  float start = screen_.y;
  for (const HudBox& box : taken_) {
    if (box.low.y > screen_.y / 2) start = std::min(start, box.low.y);
  }
  return start;
}

}  // namespace platon
