#include "client/bot/hollow_session.h"

#include <algorithm>
#include <variant>

#include "protocol/limits.h"
#include "protocol/to_server.h"

namespace platon {

namespace {

// Number of a full state that was never sent. The server accepts the inputs of such a message and ignores its hash.
constexpr std::uint8_t kUnknownSync = 255;

}  // namespace

void HollowSession::receive(std::span<const std::uint8_t> bytes, Time now) {
  if (ending()) return;
  const std::optional<ToClient> message = dialogue_.receive(bytes, now);
  if (message) std::visit([&](const auto& content) { handle(content, now); }, *message);
}

void HollowSession::handle(const Welcome& message, Time now) {
  if (const std::optional<double> lead = dialogue_.begin(message, now)) startRound(message.round, *lead);
}

void HollowSession::handle(const RoundStart& message, Time) {
  if (exchange_) startRound(message.round, exchange_->clock().lead());
}

void HollowSession::startRound(std::uint32_t id, double lead) {
  exchange_.emplace(id, lead);
  confirmed_ = {0, 0, kUnknownSync};
  sync_ = 0;
  next_ = 0;
}

void HollowSession::handle(const LevelChunk& message, Time) {
  hasLevel_ = hasLevel_ || levelText_.add(message.total, message.offset, message.bytes);
}

// The hash of this state is unknown until the ticks after it arrive.
void HollowSession::handle(const StateChunk& message, Time) {
  if (!exchange_ || !exchange_->receive(message)) return;
  confirmed_ = {message.tick, 0, kUnknownSync};
  sync_ = message.sync;
}

void HollowSession::handle(const ConfirmedTicks& message, Time now) {
  dialogue_.measure(message, now);
  if (!hasLevel_ || !exchange_ || !exchange_->receive(message, confirmed_.ticks, now)) return;
  const std::uint32_t newest = message.from + message.count;
  confirmedTicks_ += newest - confirmed_.ticks;
  confirmed_ = {newest, message.hash, sync_};
}

void HollowSession::update(Time now, const Buttons& buttons) {
  if (ending() || !hasLevel_ || !exchange_) return;
  const std::uint32_t end = confirmed_.ticks + std::min(kMaxInputsPerMessage, UINT32_MAX - confirmed_.ticks);
  next_ = std::max(next_, confirmed_.ticks);
  const std::function<InputsByLocal()> inputs = [&buttons] {
    return InputsByLocal{{{static_cast<std::uint8_t>(buttons().buttons | Input::kPresent)}}};
  };
  exchange_->update(now, next_);
  for (; next_ < end && exchange_->isDue(next_); ++next_) exchange_->choose(next_, inputs);
  if (auto message = exchange_->takeMessage(now, confirmed_)) dialogue_.sendInputs(std::move(*message), now);
}

void HollowSession::leave() {
  if (!ending()) dialogue_.send(Leave{}, true);
}

}  // namespace platon
