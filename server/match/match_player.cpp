#include "server/match/match_player.h"

#include <algorithm>
#include <utility>

namespace platon {

void MatchPlayer::startRound() {
  inputs_ = InputBuffer();
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
  forget();
  started_ = false;
}

void MatchPlayer::takeUp(std::string name) {
  name_ = std::move(name);
  inputs_.clear();
  transfers_.clear();
  heard_ = LossMeter();
  forget();
  started_ = true;
}

void MatchPlayer::forget() {
  line_.reset();
  newTick_ = 0;
  lastInput_ = Input();
  acknowledged_ = rest_ = 0;
  requests_ = 0;
  sync_ = 0;
}

void MatchPlayer::take(const PlayerInputs& message, std::uint32_t decided) {
  started_ = true;
  for (std::size_t i = 0; i < message.inputs.size(); ++i) {
    inputs_.add(message.first + static_cast<std::uint32_t>(i), message.inputs[i]);
  }
  const std::uint32_t end = message.first + static_cast<std::uint32_t>(message.inputs.size());
  if (message.inputs.empty() || end <= newTick_) return;
  judge(message, decided);
  newTick_ = end;
  lastInput_ = message.inputs.back();
}

void MatchPlayer::hear(std::uint8_t sequence) {
  heard_.heard(sequence);
  if (!line_) line_.emplace();
}

void MatchPlayer::judge(const PlayerInputs& message, std::uint32_t decided) {
  const std::uint32_t tick = judgedTick(message);
  const std::int64_t slack = std::clamp<std::int64_t>(std::int64_t{tick} - decided, -kMaxSlack, kMaxSlack);
  if (!line_) line_.emplace();
  if (line_->slack && line_->slack->slack <= slack) return;
  line_->slack = SlackReport{tick, static_cast<std::int32_t>(slack)};
}

// An input that changes nothing does no harm when it is late: the last one is held anyway.
std::uint32_t MatchPlayer::judgedTick(const PlayerInputs& message) const {
  const std::uint32_t end = message.first + static_cast<std::uint32_t>(message.inputs.size());
  Input before = message.first <= newTick_ ? lastInput_ : message.inputs.front();
  for (std::uint32_t tick = std::max(message.first, newTick_); tick < end; ++tick) {
    const Input input = message.inputs[tick - message.first];
    if (input != before) return tick;
    before = input;
  }
  return end - 1;
}

bool MatchPlayer::isCurrent(const PlayerInputs& message) const {
  return message.sync == sync_ && message.confirmed >= acknowledged_;
}

std::uint32_t MatchPlayer::nextPart(std::uint32_t end) const {
  const std::uint32_t from = std::max(rest_, acknowledged_);
  const bool whole = rest_ > acknowledged_ || sequence_ % kWholeEvery == 0;
  return whole || end < kRecentTicks ? from : std::max(from, end - kRecentTicks);
}

std::optional<LinkReport> MatchPlayer::takeLine() {
  std::optional<LinkReport> line = std::exchange(line_, std::nullopt);
  if (!line) return line;
  line->sequence = heard_.newest();
  line->lostPercent = heard_.lostPercent();
  return line;
}

void MatchPlayer::sendLevel(const LevelPointer& level) {
  const auto same = [&level](const Transfer& transfer) { return transfer.isLevel(level->hash); };
  if (requests_ == kRequestsPerRound || std::any_of(transfers_.begin(), transfers_.end(), same)) return;
  ++requests_;
  transfers_.emplace_back(level);
}

void MatchPlayer::sendState(std::uint32_t round, std::uint32_t tick, std::vector<std::uint8_t> state,
                            std::uint64_t now) {
  sync_ = sync_ == UINT8_MAX ? 1 : static_cast<std::uint8_t>(sync_ + 1);
  acknowledged_ = tick;
  nextState_ = now + kTicksBetweenStates;
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
  transfers_.emplace_back(round, tick, sync_, std::move(state));
}

std::optional<std::vector<std::uint8_t>> MatchPlayer::nextPiece() {
  if (transfers_.empty()) return std::nullopt;
  std::vector<std::uint8_t> piece = transfers_.front().next();
  if (transfers_.front().done()) transfers_.pop_front();
  return piece;
}

}  // namespace platon
