#include "client/ui/controls/mouse_look.h"

#include <utility>

namespace platon {

void MouseLook::handle(const PointerEvent& event) {
  const glm::dvec2 way = event.place - std::exchange(place_, event.place);
  if (held_) turn_ += kTurn * glm::dvec2(-way.x, way.y);
  if (event.button != PointerEvent::Button::kRight) return;
  if (event.kind == PointerEvent::Kind::kPress) held_ = true;
  if (event.kind == PointerEvent::Kind::kRelease) held_ = false;
}

void MouseLook::release() {
  held_ = false;
  turn_ = glm::dvec2(0);
}

LookInput MouseLook::take(LookInput others) {
  others.held = others.held || held_;
  const glm::dvec2 turn = std::exchange(turn_, glm::dvec2(0));
  if (held_) others.turn += turn;
  return others;
}

}  // namespace platon
