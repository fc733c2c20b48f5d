#include "client/ui/input_mapper.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

namespace platon {
namespace {

// The directions of the keyboard.
constexpr std::initializer_list<Key> kLeftKeys{Key::kArrowLeft, Key::kA};
constexpr std::initializer_list<Key> kRightKeys{Key::kArrowRight, Key::kD};
constexpr std::initializer_list<Key> kUpKeys{Key::kArrowUp, Key::kW};
constexpr std::initializer_list<Key> kDownKeys{Key::kArrowDown, Key::kS};

bool isAny(const std::bitset<kKeyCount>& active, std::initializer_list<Key> keys) {
  return std::any_of(keys.begin(), keys.end(), [&](Key key) { return active[static_cast<std::size_t>(key)]; });
}

std::optional<Action> actionOf(const KeyEvent& event, bool menuOpen) {
  switch (event.key) {
    case Key::kEscape:
    case Key::kPadStart:
      return menuOpen ? std::nullopt : std::optional(Action::kOpenMenu);
    case Key::kF1:
      return Action::kToggleHelp;
    case Key::kF3:
      return Action::kToggleNetGraph;
    case Key::kF11:
      return Action::kToggleFullscreen;
    case Key::kF12:
      return Action::kTakePicture;
    case Key::kE:
      return menuOpen ? std::nullopt : std::optional(Action::kWatchNext);
    case Key::kT:
      return menuOpen ? std::nullopt : std::optional(Action::kSay);
    case Key::kV:
      return menuOpen ? std::nullopt : std::optional(Action::kToggleVote);
    case Key::kEnter:
      return event.alt ? std::optional(Action::kToggleFullscreen) : std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Action> InputMapper::handle(const KeyEvent& event, bool menuOpen) {
  if (event.kind == KeyEvent::Kind::kCharacter) return std::nullopt;
  const auto index = static_cast<std::size_t>(event.key);
  if (menuOpen) pressed_.reset();
  if (event.kind == KeyEvent::Kind::kRelease) held_.reset(index);
  if (event.kind == KeyEvent::Kind::kPress && !menuOpen) {
    held_.set(index);
    pressed_.set(index);
  }
  return event.kind == KeyEvent::Kind::kPress ? actionOf(event, menuOpen) : std::nullopt;
}

HeldKeys InputMapper::takeHeld() {
  std::bitset<kKeyCount> active = held_ | pressed_;
  pressed_.reset();
  if (isAny(held_, {Key::kTab})) {
    for (const std::initializer_list<Key>& keys : {kLeftKeys, kRightKeys, kUpKeys, kDownKeys}) {
      for (const Key key : keys) active.reset(static_cast<std::size_t>(key));
    }
  }
  const auto any = [&active](std::initializer_list<Key> keys) { return isAny(active, keys); };
  HeldKeys keys;
  keys.left = any({Key::kArrowLeft, Key::kA, Key::kPadLeft});
  keys.right = any({Key::kArrowRight, Key::kD, Key::kPadRight});
  keys.up = any({Key::kArrowUp, Key::kW});  // not the gamepad's: pushing the stick up must not jump
  keys.down = any({Key::kArrowDown, Key::kS, Key::kPadDown});
  keys.jump = any({Key::kSpace, Key::kPadA});
  keys.walk = any({Key::kPadWalk});
  keys.creep = any({Key::kShift, Key::kPadCreep});
  keys.restart = any({Key::kR, Key::kPadBack});
  return keys;
}

LookInput InputMapper::look() const {
  const auto turns = [this](std::initializer_list<Key> withTab, Key stick) {
    return isAny(held_, {stick}) || (isAny(held_, {Key::kTab}) && isAny(held_, withTab)) ? 1 : 0;
  };
  LookInput input;
  input.direction.x = turns(kRightKeys, Key::kPadLookRight) - turns(kLeftKeys, Key::kPadLookLeft);
  input.direction.y = turns(kUpKeys, Key::kPadLookUp) - turns(kDownKeys, Key::kPadLookDown);
  input.held = isAny(held_, {Key::kTab, Key::kPadLookLeft, Key::kPadLookRight, Key::kPadLookUp, Key::kPadLookDown});
  return input;
}

}  // namespace platon
