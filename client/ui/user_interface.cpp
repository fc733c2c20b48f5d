#include "client/ui/user_interface.h"

#include <optional>

namespace platon {

void UserInterface::handle(const KeyEvent& event) {
  const std::optional<Action> action = mapper_.handle(event, menu_.open());
  if (action) perform(*action);
}

HeldKeys UserInterface::takeHeld() {
  const HeldKeys held = mapper_.takeHeld();
  return menu_.open() ? HeldKeys() : held;
}

void UserInterface::perform(Action action) {
  switch (action) {
    case Action::kToggleMenu:
      return menu_.toggle();
    case Action::kMenuUp:
      return menu_.step(Menu::Step::kUp, settings_);
    case Action::kMenuDown:
      return menu_.step(Menu::Step::kDown, settings_);
    case Action::kMenuLess:
      return menu_.step(Menu::Step::kLess, settings_);
    case Action::kMenuMore:
      return menu_.step(Menu::Step::kMore, settings_);
    case Action::kMenuChoose:
      return menu_.choose(settings_);
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
  }
}

}  // namespace platon
