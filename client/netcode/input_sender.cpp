#include "client/netcode/input_sender.h"

#include <algorithm>
#include <chrono>

namespace platon {

namespace {

constexpr std::uint32_t kTicksBetweenMessages = 4;
constexpr std::uint32_t kRepeats = 2;  // of a change, one per tick
constexpr Time kIdleInterval = std::chrono::milliseconds(80);

}  // namespace

void SendSchedule::addInput(Input input) {
  hasNew_ = true;
  changed_ = changed_ || input != last_;
  last_ = input;
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

void InputSender::add(std::uint32_t tick, Input input) {
  if (!first_) first_ = tick;
  end_ = tick + 1;
  inputs_[tick % inputs_.size()] = input;
  schedule_.addInput(input);
}

std::optional<PlayerInputs> InputSender::takeMessage(Time now, const ConfirmedState& confirmed) {
  const std::uint32_t end = std::max(end_, confirmed.ticks);
  if (!schedule_.due(now, end)) return std::nullopt;
  schedule_.sent(now, end);
  PlayerInputs message{round_, confirmed.sync, confirmed.ticks, confirmed.hash, 0, {}};
  message.first = std::max(confirmed.ticks, first_.value_or(0));
  // A full state of an earlier tick can leave more unconfirmed inputs than a message may hold.
  const auto count = std::min<std::uint32_t>(end - std::min(message.first, end), kMaxInputsPerMessage);
  for (std::uint32_t i = 0; i < count; ++i) message.inputs.push_back(inputs_[(message.first + i) % inputs_.size()]);
  return message;
}

}  // namespace platon
