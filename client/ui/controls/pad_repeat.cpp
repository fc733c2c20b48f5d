#include "client/ui/controls/pad_repeat.h"

namespace platon {
namespace {

bool isDirection(Key key) {
  return key == Key::kPadLeft || key == Key::kPadRight || key == Key::kPadUp || key == Key::kPadDown;
}

}  // namespace

void PadRepeat::observe(const KeyEvent& event, Time now) {
  if (event.kind == KeyEvent::Kind::kRelease && event.key == held_) held_.reset();
  if (event.kind != KeyEvent::Kind::kPress || !isDirection(event.key)) return;
  held_ = event.key;
  next_ = now + kDelay;
}

// Late pictures are not made up for: the focus would leap.
std::optional<KeyEvent> PadRepeat::repeat(bool repeats, Time now) {
  if (!repeats) held_.reset();
  if (!held_ || now < next_) return std::nullopt;
  next_ += kInterval;
  if (next_ <= now) next_ = now + kInterval;
  return KeyEvent{*held_, KeyEvent::Kind::kRepeat};
}

}  // namespace platon
