#include "server/match/match_client.h"

#include <algorithm>

namespace platon {

void InputArrival::count(std::uint8_t sequence) {
  loss_.received(sequence);
  if (!report_) report_.emplace();
}

void InputArrival::note(const SlackReport& slack) {
  if (!report_) report_.emplace();
  if (!report_->slack || slack.slack < report_->slack->slack) report_->slack = slack;
}

std::optional<LinkReport> InputArrival::take() {
  std::optional<LinkReport> report = std::exchange(report_, std::nullopt);
  if (!report) return report;
  report->sequence = loss_.newest();
  report->lostPercent = loss_.lostPercent();
  return report;
}

MatchClient::MatchClient(const std::optional<SessionToken>& token, MatchPlayer first) : token_(token) {
  players_.emplace(0, std::move(first));
}

MatchPlayer* MatchClient::player(std::uint32_t local) {
  const auto found = players_.find(local);
  return found == players_.end() ? nullptr : &found->second;
}

const MatchPlayer* MatchClient::player(std::uint32_t local) const {
  const auto found = players_.find(local);
  return found == players_.end() ? nullptr : &found->second;
}

std::optional<std::uint32_t> MatchClient::localIn(std::uint32_t slot) const {
  for (const auto& [local, player] : players_) {
    if (player.slot() == slot) return local;
  }
  return std::nullopt;
}

SlotsByLocal MatchClient::slots() const {
  std::array<std::optional<std::uint32_t>, kMaxLocalPlayers> slots;
  for (const auto& [local, player] : players_) slots[local] = player.slot();
  return slots;
}

std::uint32_t MatchClient::activePlayers(std::uint64_t now) const {
  return static_cast<std::uint32_t>(
      std::count_if(players_.begin(), players_.end(), [now](const auto& entry) { return entry.second.isActive(now); }));
}

void MatchClient::startRound() {
  for (auto& [local, player] : players_) player.startRound(0);
  arrival_.startRound();
  ticks_.startRound(false);
  transfers_.startRound();
  wish_.clear();
}

void MatchClient::resume() {
  for (auto& [local, player] : players_) player.resume();
  arrival_ = InputArrival();
  ticks_.startRound(true);
  transfers_.resume();
  wish_.clear();
}

std::uint64_t MatchClient::addInputs(const PlayerInputs& message, std::uint32_t decided, std::uint64_t now) {
  ticks_.start();
  std::uint64_t missed = addInputsOf(0, {message.first, message.inputs}, decided, now);
  for (const CompanionInputs& each : message.companions) {
    missed += addInputsOf(each.local, {each.first, each.inputs}, decided, now);
  }
  return missed;
}

std::uint64_t MatchClient::addInputsOf(std::uint32_t local, const TickInputs& inputs, std::uint32_t decided,
                                       std::uint64_t now) {
  MatchPlayer* const sender = player(local);
  if (sender == nullptr) return 0;
  const std::uint64_t before = sender->missedInputs();
  if (const auto slack = sender->addInputs(inputs, decided, now)) arrival_.note(*slack);
  return sender->missedInputs() - before;
}

bool MatchClient::isCurrent(const PlayerInputs& message) const {
  return message.sync == transfers_.sync() && message.confirmed >= ticks_.acknowledged();
}

void MatchClient::vote(bool next, std::uint64_t now) {
  wish_.set(next);
  first().noteActivity(now);
}

}  // namespace platon
