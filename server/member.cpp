#include "server/member.h"

#include <algorithm>
#include <utility>

namespace platon {

void Member::startRound() {
  inputs_ = InputBuffer();
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
  slack_.reset();
  acknowledged_ = rest_ = 0;
  requests_ = 0;
  sync_ = 0;
  started_ = false;
}

void Member::take(const PlayerInputs& message, std::uint32_t decided) {
  started_ = true;
  for (std::size_t i = 0; i < message.inputs.size(); ++i) {
    inputs_.add(message.first + static_cast<std::uint32_t>(i), message.inputs[i]);
  }
  if (message.inputs.empty()) return;
  const std::uint32_t newest = message.first + static_cast<std::uint32_t>(message.inputs.size()) - 1;
  const std::int64_t slack = std::clamp<std::int64_t>(std::int64_t{newest} - decided, -kMaxSlack, kMaxSlack);
  if (!slack_ || slack < slack_->slack) slack_ = SlackReport{newest, static_cast<std::int32_t>(slack)};
}

bool Member::isCurrent(const PlayerInputs& message) const {
  return message.sync == sync_ && message.confirmed >= acknowledged_;
}

std::optional<SlackReport> Member::takeSlack() { return std::exchange(slack_, std::nullopt); }

void Member::sendLevel(const LevelPointer& level) {
  const auto same = [&level](const Transfer& transfer) { return transfer.isLevel(level->hash); };
  if (requests_ == kRequestsPerRound || std::any_of(transfers_.begin(), transfers_.end(), same)) return;
  ++requests_;
  transfers_.emplace_back(level);
}

void Member::sendState(std::uint32_t round, std::uint32_t tick, std::vector<std::uint8_t> state, std::uint64_t now) {
  sync_ = sync_ == UINT8_MAX ? 1 : static_cast<std::uint8_t>(sync_ + 1);
  acknowledged_ = tick;
  nextState_ = now + kTicksBetweenStates;
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
  transfers_.emplace_back(round, tick, sync_, std::move(state));
}

std::optional<std::vector<std::uint8_t>> Member::nextPiece() {
  if (transfers_.empty()) return std::nullopt;
  std::vector<std::uint8_t> piece = transfers_.front().next();
  if (transfers_.front().done()) transfers_.pop_front();
  return piece;
}

}  // namespace platon
