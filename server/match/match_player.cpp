#include "server/match/match_player.h"

#include <algorithm>
#include <utility>

namespace platon {

bool InputBuffer::add(std::uint32_t tick, Input input) {
  if (tick < next_ && next_ - tick <= kWindow) noteLate(tick, input);
  if (tick < next_ || tick - next_ >= kWindow || at(tick)) return false;
  at(tick) = input;
  return true;
}

// A tick is counted once: inputs are sent again and again.
void InputBuffer::noteLate(std::uint32_t tick, Input input) {
  Input& decided = decided_[tick % kWindow];
  if (decided.has(Input::kPresent) && decided != input) ++missed_;
  decided = input;
}

Input InputBuffer::decide() {
  std::optional<Input>& input = at(next_);
  ++next_;
  if (input) {
    last_ = *input;
    ticksWithoutInput_ = 0;
    input.reset();
  } else if (last_.has(Input::kPresent)) {
    if (++ticksWithoutInput_ > kHoldTicks) last_ = Input{Input::kPresent};
  }
  decided_[(next_ - 1) % kWindow] = last_;
  return last_;
}

void MatchPlayer::startRound(std::uint32_t tick) {
  buffer_ = InputBuffer(tick);
  forgetNewest();
}

void MatchPlayer::resume() {
  buffer_.clear();
  forgetNewest();
}

void MatchPlayer::forgetNewest() {
  end_ = 0;
  newest_ = Input();
}

std::optional<SlackReport> MatchPlayer::addInputs(const TickInputs& inputs, std::uint32_t decided, std::uint64_t now) {
  for (std::uint32_t tick = inputs.first; tick < inputs.end(); ++tick) {
    buffer_.add(tick, inputs.inputs[tick - inputs.first]);
  }
  if (inputs.inputs.empty() || inputs.end() <= end_) return std::nullopt;
  const std::uint32_t tick = measuredTick(inputs);
  const std::int64_t slack = std::clamp<std::int64_t>(std::int64_t{tick} - decided, -kMaxSlack, kMaxSlack);
  if (changesButtons(inputs)) noteActivity(now);
  end_ = inputs.end();
  newest_ = inputs.inputs.back();
  return SlackReport{tick, static_cast<std::int32_t>(slack)};
}

bool MatchPlayer::changesButtons(const TickInputs& inputs) {
  bool changed = false;
  for (std::size_t i = end_ - std::min(end_, inputs.first); i < inputs.inputs.size(); ++i) {
    const auto buttons = static_cast<std::uint8_t>(inputs.inputs[i].buttons & ~Input::kPresent);
    if (buttons != std::exchange(buttons_, buttons)) changed = true;
  }
  return changed;
}

// Inputs that change nothing are skipped: when late they are harmless, since the server keeps applying the last one.
std::uint32_t MatchPlayer::measuredTick(const TickInputs& inputs) const {
  Input before = inputs.first <= end_ ? newest_ : inputs.inputs.front();
  for (std::uint32_t tick = std::max(inputs.first, end_); tick < inputs.end(); ++tick) {
    const Input input = inputs.inputs[tick - inputs.first];
    if (input != before) return tick;
    before = input;
  }
  return inputs.end() - 1;
}

}  // namespace platon
