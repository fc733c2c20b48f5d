#include "server/match/match_player.h"

#include <algorithm>
#include <utility>

namespace platon {

void MatchPlayer::startRound() {
  inputs_ = InputBuffer();
  wish_.clear();
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
  resetProgress();
  started_ = false;
}

void MatchPlayer::resume(std::string name) {
  name_ = std::move(name);
  inputs_.clear();
  wish_.clear();
  transfers_.clear();
  loss_ = LossMeter();
  resetProgress();
  started_ = true;
}

void MatchPlayer::resetProgress() {
  linkReport_.reset();
  inputsEnd_ = 0;
  newestInput_ = Input();
  acknowledged_ = continueAt_ = 0;
  messagesSinceFull_ = kFullRepeatInterval;
  levelRequests_ = 0;
  sync_ = 0;
}

void MatchPlayer::addInputs(const PlayerInputs& message, std::uint32_t decided, std::uint64_t now) {
  started_ = true;
  for (std::size_t i = 0; i < message.inputs.size(); ++i) {
    inputs_.add(message.first + static_cast<std::uint32_t>(i), message.inputs[i]);
  }
  const std::uint32_t end = message.first + static_cast<std::uint32_t>(message.inputs.size());
  if (message.inputs.empty() || end <= inputsEnd_) return;
  measureSlack(message, decided);
  noteButtons(message, now);
  inputsEnd_ = end;
  newestInput_ = message.inputs.back();
}

void MatchPlayer::countMessage(std::uint8_t sequence) {
  loss_.received(sequence);
  if (!linkReport_) linkReport_.emplace();
}

void MatchPlayer::measureSlack(const PlayerInputs& message, std::uint32_t decided) {
  const std::uint32_t tick = measuredTick(message);
  const std::int64_t slack = std::clamp<std::int64_t>(std::int64_t{tick} - decided, -kMaxSlack, kMaxSlack);
  if (!linkReport_) linkReport_.emplace();
  if (linkReport_->slack && linkReport_->slack->slack <= slack) return;
  linkReport_->slack = SlackReport{tick, static_cast<std::int32_t>(slack)};
}

void MatchPlayer::noteButtons(const PlayerInputs& message, std::uint64_t now) {
  for (std::size_t i = inputsEnd_ - std::min(inputsEnd_, message.first); i < message.inputs.size(); ++i) {
    const auto buttons = static_cast<std::uint8_t>(message.inputs[i].buttons & ~Input::kPresent);
    if (buttons != std::exchange(buttons_, buttons)) activeAt_ = now;
  }
}

// Inputs that change nothing are skipped: when late they are harmless, since the server keeps applying the last one.
std::uint32_t MatchPlayer::measuredTick(const PlayerInputs& message) const {
  const std::uint32_t end = message.first + static_cast<std::uint32_t>(message.inputs.size());
  Input before = message.first <= inputsEnd_ ? newestInput_ : message.inputs.front();
  for (std::uint32_t tick = std::max(message.first, inputsEnd_); tick < end; ++tick) {
    const Input input = message.inputs[tick - message.first];
    if (input != before) return tick;
    before = input;
  }
  return end - 1;
}

void MatchPlayer::vote(bool next, std::uint64_t now) {
  wish_.set(next);
  activeAt_ = now;
}

bool MatchPlayer::isCurrent(const PlayerInputs& message) const {
  return message.sync == sync_ && message.confirmed >= acknowledged_;
}

std::uint32_t MatchPlayer::nextTickToSend(std::uint32_t end, std::uint32_t interval) const {
  const std::uint32_t from = std::max(continueAt_, acknowledged_);
  const bool all = continueAt_ != 0 || messagesSinceFull_ + 1 >= kFullRepeatInterval;
  const std::uint32_t recent = std::max(kRecentTicks, kRecentMessages * interval);
  return all || end < recent ? from : std::max(from, end - recent);
}

void MatchPlayer::ticksSent(std::uint32_t from, std::uint32_t tick, std::uint32_t end) {
  continueAt_ = tick < end ? tick : 0;
  lastTicks_ = tick - from;
  messagesSinceFull_ = from == acknowledged_ ? 0 : messagesSinceFull_ + 1;
}

std::optional<LinkReport> MatchPlayer::takeLinkReport() {
  std::optional<LinkReport> report = std::exchange(linkReport_, std::nullopt);
  if (!report) return report;
  report->sequence = loss_.newest();
  report->lostPercent = loss_.lostPercent();
  return report;
}

void MatchPlayer::sendLevel(Transfer level) {
  const auto same = [&level](const Transfer& transfer) { return transfer.isSameLevel(level); };
  if (levelRequests_ == kMaxLevelsPerRound || std::any_of(transfers_.begin(), transfers_.end(), same)) return;
  ++levelRequests_;
  transfers_.push_back(std::move(level));
}

void MatchPlayer::sendState(Transfer state, std::uint32_t tick, std::uint64_t now) {
  sync_ = nextSync();
  acknowledged_ = tick;
  nextStateAt_ = now + kTicksBetweenStates;
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
  transfers_.push_back(std::move(state));
}

std::optional<SharedBytes> MatchPlayer::nextChunk() {
  if (transfers_.empty()) return std::nullopt;
  SharedBytes chunk = transfers_.front().nextChunk();
  if (transfers_.front().done()) transfers_.pop_front();
  return chunk;
}

}  // namespace platon
