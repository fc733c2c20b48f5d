#include "server/match/input_buffer.h"

namespace platon {

bool InputBuffer::add(std::uint32_t tick, Input input) {
  if (tick < next_ || tick - next_ >= kWindow || at(tick)) return false;
  at(tick) = input;
  return true;
}

Input InputBuffer::take() {
  std::optional<Input>& slot = at(next_);
  ++next_;
  if (slot) {
    held_ = *slot;
    silence_ = 0;
    slot.reset();
  } else if (held_.has(Input::kPresent)) {
    ++missed_;
    if (++silence_ > kHoldTicks) held_ = Input{Input::kPresent};
  }
  return held_;
}

}  // namespace platon
