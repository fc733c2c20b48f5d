#include "client/ui/user_interface.h"

namespace platon {

std::optional<Action> UserInterface::handle(const KeyEvent& event, bool menuOpen) {
  if (event.kind == KeyEvent::Kind::kPress) gamepadUsed_ = isOfGamepad(event.key);
  mapper_.configure(settings_.bindings, settings_.toggled);
  const std::optional<Action> action = mapper_.handle(event, menuOpen);
  if (action == Action::kToggleHelp) helpShown_ = !helpShown_;
  if (action == Action::kToggleNetGraph) settings_.netGraph = !settings_.netGraph;
  if (action == Action::kToggleFullscreen) settings_.fullscreen = !settings_.fullscreen;
  return action;
}

HeldKeys UserInterface::takeHeld(bool menuOpen) {
  mapper_.configure(settings_.bindings, settings_.toggled);
  HeldKeys held = mapper_.takeHeld();
  if (menuOpen) return {};
  held.restart = std::exchange(restart_, false) || held.restart;
  return held;
}

}  // namespace platon
