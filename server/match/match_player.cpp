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

void ClientInputs::startRound(std::uint32_t tick) {
  buffer_ = InputBuffer(tick);
  forgetNewest();
}

void ClientInputs::resume() {
  buffer_.clear();
  loss_ = LossMeter();
  forgetNewest();
}

void ClientInputs::forgetNewest() {
  linkReport_.reset();
  end_ = 0;
  newest_ = Input();
}

void ClientInputs::countMessage(std::uint8_t sequence) {
  loss_.received(sequence);
  if (!linkReport_) linkReport_.emplace();
}

bool ClientInputs::add(const PlayerInputs& message, std::uint32_t decided) {
  for (std::size_t i = 0; i < message.inputs.size(); ++i) {
    buffer_.add(message.first + static_cast<std::uint32_t>(i), message.inputs[i]);
  }
  const std::uint32_t end = message.first + static_cast<std::uint32_t>(message.inputs.size());
  if (message.inputs.empty() || end <= end_) return false;
  measureSlack(message, decided);
  const bool changed = changesButtons(message);
  end_ = end;
  newest_ = message.inputs.back();
  return changed;
}

void ClientInputs::measureSlack(const PlayerInputs& message, std::uint32_t decided) {
  const std::uint32_t tick = measuredTick(message);
  const std::int64_t slack = std::clamp<std::int64_t>(std::int64_t{tick} - decided, -kMaxSlack, kMaxSlack);
  if (!linkReport_) linkReport_.emplace();
  if (linkReport_->slack && linkReport_->slack->slack <= slack) return;
  linkReport_->slack = SlackReport{tick, static_cast<std::int32_t>(slack)};
}

bool ClientInputs::changesButtons(const PlayerInputs& message) {
  bool changed = false;
  for (std::size_t i = end_ - std::min(end_, message.first); i < message.inputs.size(); ++i) {
    const auto buttons = static_cast<std::uint8_t>(message.inputs[i].buttons & ~Input::kPresent);
    if (buttons != std::exchange(buttons_, buttons)) changed = true;
  }
  return changed;
}

// Inputs that change nothing are skipped: when late they are harmless, since the server keeps applying the last one.
std::uint32_t ClientInputs::measuredTick(const PlayerInputs& message) const {
  const std::uint32_t end = message.first + static_cast<std::uint32_t>(message.inputs.size());
  Input before = message.first <= end_ ? newest_ : message.inputs.front();
  for (std::uint32_t tick = std::max(message.first, end_); tick < end; ++tick) {
    const Input input = message.inputs[tick - message.first];
    if (input != before) return tick;
    before = input;
  }
  return end - 1;
}

std::optional<LinkReport> ClientInputs::takeLinkReport() {
  std::optional<LinkReport> report = std::exchange(linkReport_, std::nullopt);
  if (!report) return report;
  report->sequence = loss_.newest();
  report->lostPercent = loss_.lostPercent();
  return report;
}

void MatchPlayer::startRound() {
  inputs_.startRound(0);
  ticks_.startRound(false);
  transfers_.startRound();
  wish_.clear();
}

void MatchPlayer::resume(std::string name) {
  name_ = std::move(name);
  inputs_.resume();
  ticks_.startRound(true);
  transfers_.resume();
  wish_.clear();
}

std::uint64_t MatchPlayer::addInputs(const PlayerInputs& message, std::uint32_t decided, std::uint64_t now) {
  const std::uint64_t before = inputs_.missed();
  ticks_.start();
  if (inputs_.add(message, decided)) activeAt_ = now;
  return inputs_.missed() - before;
}

bool MatchPlayer::isCurrent(const PlayerInputs& message) const {
  return message.sync == transfers_.sync() && message.confirmed >= ticks_.acknowledged();
}

void MatchPlayer::vote(bool next, std::uint64_t now) {
  wish_.set(next);
  activeAt_ = now;
}

}  // namespace platon
