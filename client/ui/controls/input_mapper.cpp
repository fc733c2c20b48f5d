#include "client/ui/controls/input_mapper.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

namespace platon {
namespace {

std::optional<Action> actionOf(Control control) {
  switch (control) {
    case Control::kVote:
      return Action::kToggleVote;
    case Control::kWatch:
      return Action::kWatchNext;
    case Control::kSay:
      return Action::kSay;
    case Control::kEmote1:
      return Action::kEmote1;
    case Control::kEmote2:
      return Action::kEmote2;
    case Control::kEmote3:
      return Action::kEmote3;
    case Control::kEmote4:
      return Action::kEmote4;
    default:
      return std::nullopt;
  }
}

// Of the keys that have the same meaning for everybody.
std::optional<Action> fixedActionOf(const KeyEvent& event, bool menuOpen) {
  switch (event.key) {
    case Key::kEscape:
    case Key::kPadStart:
      return menuOpen ? std::nullopt : std::optional(Action::kOpenMenu);
    case Key::kF1:
      return menuOpen ? std::nullopt : std::optional(Action::kToggleHelp);
    case Key::kF3:
      return menuOpen ? std::nullopt : std::optional(Action::kToggleNetGraph);
    case Key::kF11:
      return Action::kToggleFullscreen;
    case Key::kF12:
      return Action::kTakePicture;
    case Key::kEnter:
      return event.alt ? std::optional(Action::kToggleFullscreen) : std::nullopt;
    default:
      return std::nullopt;
  }
}

// Of the keys that have their meaning as long as no control has them.
std::optional<Action> unboundActionOf(Key key) {
  if (key == Key::kEnter) return Action::kGoOn;
  const bool joins = key == Key::kF2 || key == Key::kPadRightTrigger;
  return joins ? std::optional(Action::kJoin) : std::nullopt;
}

}  // namespace

std::optional<Action> InputMapper::handle(const KeyEvent& event, bool menuOpen) {
  if (event.kind == KeyEvent::Kind::kCharacter) return std::nullopt;
  const auto index = static_cast<std::size_t>(event.key);
  if (menuOpen) pressed_.reset();
  if (event.kind == KeyEvent::Kind::kRelease && holders_[index] > 0) held_.set(index, --holders_[index] > 0);
  if (event.kind == KeyEvent::Kind::kPress && !menuOpen) {
    ++holders_[index];
    held_.set(index);
    pressed_.set(index);
  }
  return event.kind == KeyEvent::Kind::kPress ? press(event, menuOpen) : std::nullopt;
}

std::optional<Action> InputMapper::press(const KeyEvent& event, bool menuOpen) {
  if (const std::optional<Action> action = fixedActionOf(event, menuOpen)) return action;
  const std::optional<Control> control = menuOpen ? std::nullopt : bindings_.controlOf(event.key);
  if (!control) return menuOpen ? std::nullopt : unboundActionOf(event.key);
  if (control == Control::kSlow) slow_ = toggled_.slow && !slow_;
  if (control == Control::kLook) looking_ = toggled_.look && !looking_;
  return actionOf(*control);
}

void InputMapper::release() {
  held_.reset();
  pressed_.reset();
  holders_.fill(0);
}

void InputMapper::configure(const Bindings& bindings, const ToggledControls& toggled) {
  bindings_ = bindings;
  slow_ = slow_ && toggled.slow;
  looking_ = looking_ && toggled.look;
  toggled_ = toggled;
}

bool InputMapper::looksByKeys() const { return toggled_.look ? looking_ : bindings_.isAny(Control::kLook, held_); }

HeldKeys InputMapper::takeHeld() {
  const std::bitset<kKeyCount> active = held_ | pressed_;
  pressed_.reset();
  const bool moves = !looksByKeys();
  const auto any = [&](Control control) { return bindings_.isAny(control, active); };
  const auto is = [&active](Key key) { return active[static_cast<std::size_t>(key)]; };
  HeldKeys keys;
  keys.left = moves && any(Control::kLeft);
  keys.right = moves && any(Control::kRight);
  keys.up = moves && any(Control::kUp);
  keys.down = moves && any(Control::kDown);
  keys.jump = any(Control::kJump);
  keys.walk = is(Key::kPadWalk);
  keys.creep = is(Key::kPadCreep) || (toggled_.slow ? slow_ : any(Control::kSlow));
  keys.restart = any(Control::kRestart);
  return keys;
}

LookInput InputMapper::look() const {
  const bool byKeys = looksByKeys();
  const auto is = [this](Key key) { return held_[static_cast<std::size_t>(key)]; };
  const auto turns = [&](Control control, Key stick) {
    return is(stick) || (byKeys && bindings_.isAny(control, held_)) ? 1 : 0;
  };
  LookInput input;
  input.direction.x = turns(Control::kRight, Key::kPadLookRight) - turns(Control::kLeft, Key::kPadLookLeft);
  input.direction.y = turns(Control::kUp, Key::kPadLookUp) - turns(Control::kDown, Key::kPadLookDown);
  input.held =
      byKeys || is(Key::kPadLookLeft) || is(Key::kPadLookRight) || is(Key::kPadLookUp) || is(Key::kPadLookDown);
  return input;
}

Input Steering::input(const HeldKeys& keys, double roll, ControlFrame frame) {
  // Directions counter-clockwise from the right.
  const std::array<bool, 4> held{keys.right, keys.up, keys.left, keys.down};
  constexpr std::array<std::uint8_t, 4> kInputOf{Input::kRight, Input::kJump, Input::kLeft, Input::kDown};
  const bool anyHeld = keys.right || keys.up || keys.left || keys.down;
  if (frame == ControlFrame::kPlayer) {
    quarters_ = 0;
  } else if (!anyHeld) {
    quarters_ = static_cast<int>(std::lround(roll / (std::numbers::pi / 2)));
  }
  Input input{Input::kPresent};
  for (int direction = 0; direction < 4; ++direction) {
    const int turned = ((direction - quarters_) % 4 + 4) % 4;
    if (held[static_cast<std::size_t>(direction)]) input.buttons |= kInputOf[static_cast<std::size_t>(turned)];
  }
  if (keys.jump) input.buttons |= Input::kJump;
  if (keys.walk) input.buttons |= Input::kWalk;
  if (keys.creep) input.buttons |= Input::kCreep;
  if (keys.restart) input.buttons |= Input::kRestart;
  return validInput(input.buttons);
}

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
