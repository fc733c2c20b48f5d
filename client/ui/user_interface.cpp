#include "client/ui/user_interface.h"

#include <optional>

namespace platon {

void UserInterface::handle(const KeyEvent& event, bool menuOpen) {
  if (event.kind == KeyEvent::Kind::kPress) gamepadUsed_ = isOfGamepad(event.key);
  mapper_.configure(settings_.bindings, settings_.toggled);
  const std::optional<Action> action = mapper_.handle(event, menuOpen);
  if (action) perform(*action);
}

HeldKeys UserInterface::takeHeld(bool menuOpen) {
  mapper_.configure(settings_.bindings, settings_.toggled);
  HeldKeys held = mapper_.takeHeld();
  if (menuOpen) return {};
  held.restart = std::exchange(restart_, false) || held.restart;
  return held;
}

void UserInterface::perform(Action action) {
  switch (action) {
    case Action::kOpenMenu:
      menuAsked_ = true;
      return;
    case Action::kToggleHelp:
      helpShown_ = !helpShown_;
      return;
    case Action::kToggleNetGraph:
      settings_.netGraph = !settings_.netGraph;
      return;
    case Action::kToggleFullscreen:
      settings_.fullscreen = !settings_.fullscreen;
      return;
    case Action::kToggleVote:
      voteToggled_ = !voteToggled_;
      return;
    case Action::kGoOn:
      goOnAsked_ = true;
      return;
    case Action::kTakePicture:
      pictureAsked_ = true;
      return;
    case Action::kSay:
      sayAsked_ = true;
      return;
    case Action::kWatchNext:
      watchAsked_ = true;
      return;
  }
}

}  // namespace platon
