#include "client/ui/first_keys.h"

#include "platon/game/game.h"

namespace platon {
namespace {

constexpr std::uint32_t kRunTicks = kTicksPerSecond / 2;  // long enough to see the ball roll

}  // namespace

void FirstKeys::observe(const HeldKeys& held, std::uint32_t face) {
  const auto begin = [this](Step step) {
    step_ = step;
    ticks_ = 0;
  };
  switch (step_) {
    case Step::kRun:
      ticks_ += held.left || held.right ? 1 : 0;
      if (ticks_ >= kRunTicks) begin(Step::kJump);
      return;
    case Step::kJump:
      face_ = face;
      ticks_ += held.jump || held.up ? 1 : 0;
      if (ticks_ > 0) begin(Step::kCross);
      return;
    case Step::kCross:
      if (face != face_) begin(Step::kDone);
      return;
    case Step::kDone:
      return;
  }
}

std::string FirstKeys::hint(const KeyHints& keys) const {
  switch (step_) {
    case Step::kRun:
      return keys.run() + ": roll";
    case Step::kJump:
      return keys.to(Control::kJump, "jump; hold it to jump higher");
    case Step::kCross:
      return "Roll over an edge: the solid turns, and your down with it";
    default:
      return {};
  }
}

}  // namespace platon
