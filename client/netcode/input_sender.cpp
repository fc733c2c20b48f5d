#include "client/netcode/input_sender.h"

#include <algorithm>
#include <chrono>

namespace platon {

namespace {

constexpr std::uint32_t kTicksBetweenMessages = 4;
constexpr std::uint32_t kRepeats = 2;  // of a change, one per tick
constexpr Time kIdleInterval = std::chrono::milliseconds(80);

}  // namespace

void SendSchedule::addInputs(const InputsByLocal& inputs) {
  hasNew_ = true;
  changed_ = changed_ || inputs != last_;
  last_ = inputs;
}

bool SendSchedule::due(Time now, std::uint32_t end) const {
  if (!sentAt_ || now - *sentAt_ >= kIdleInterval || urgent_) return true;
  if (!hasNew_ || end <= sentEnd_) return false;
  return repeats_ > 0 || end - sentEnd_ >= kTicksBetweenMessages || changed_;
}

void SendSchedule::sent(Time now, std::uint32_t end) {
  repeats_ = changed_ ? kRepeats : repeats_ - std::min(repeats_, 1u);
  hasNew_ = changed_ = urgent_ = false;
  sentAt_ = now;
  sentEnd_ = end;
}

void InputSender::add(std::uint32_t tick, const InputsByLocal& inputs) {
  for (std::size_t local = 0; local < inputs.size(); ++local) {
    if (!inputs[local].has(Input::kPresent))
      firsts_[local].reset();
    else if (!firsts_[local])
      firsts_[local] = tick;
  }
  end_ = tick + 1;
  inputs_[tick % inputs_.size()] = inputs;
  schedule_.addInputs(inputs);
}

std::vector<Input> InputSender::inputsOf(std::size_t local, std::uint32_t first, std::uint32_t end) const {
  std::vector<Input> inputs;
  for (std::uint32_t tick = first; tick < end; ++tick) inputs.push_back(inputs_[tick % inputs_.size()][local]);
  return inputs;
}

std::optional<PlayerInputs> InputSender::takeMessage(Time now, const ConfirmedState& confirmed) {
  const std::uint32_t end = std::max(end_, confirmed.ticks);
  if (!schedule_.due(now, end)) return std::nullopt;
  schedule_.sent(now, end);
  PlayerInputs message{round_, confirmed.sync, confirmed.ticks, confirmed.hash, 0, {}};
  message.first = std::max(confirmed.ticks, firsts_[0].value_or(0));
  // A full state of an earlier tick can leave more unconfirmed inputs than a message may hold.
  const std::uint32_t until = message.first + std::min(end - std::min(message.first, end), kMaxInputsPerMessage);
  message.inputs = inputsOf(0, message.first, until);
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local) {
    if (!firsts_[local]) continue;
    const std::uint32_t first = std::max(message.first, *firsts_[local]);
    if (first < until) message.companions.push_back({local, first, inputsOf(local, first, until)});
  }
  return message;
}

}  // namespace platon
