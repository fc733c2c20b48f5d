#include "server/match/input_buffer.h"

namespace platon {

bool InputBuffer::add(std::uint32_t tick, Input input) {
  if (tick < next_ || tick - next_ >= kWindow || at(tick)) return false;
  at(tick) = input;
  return true;
}

Input InputBuffer::decide() {
  std::optional<Input>& input = at(next_);
  ++next_;
  if (input) {
    last_ = *input;
    ticksWithoutInput_ = 0;
    input.reset();
  } else if (last_.has(Input::kPresent)) {
    ++missed_;
    if (++ticksWithoutInput_ > kHoldTicks) last_ = Input{Input::kPresent};
  }
  return last_;
}

}  // namespace platon
