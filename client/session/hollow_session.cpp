#include "client/session/hollow_session.h"

#include <algorithm>
#include <variant>

#include "protocol/to_server.h"

namespace platon {

namespace {

// Number of a full state that was never sent. The server accepts the inputs of such a message and ignores its hash.
constexpr std::uint8_t kUnknownSync = 255;

}  // namespace

HollowSession::HollowSession(const std::string& name, Moment now, const std::optional<SessionToken>& token)
    : helloAt_(now) {
  Hello hello;
  hello.name = name;
  hello.token = token;
  outgoing_.push_back({encode(hello), true});
}

void HollowSession::leave() {
  if (!ending_) outgoing_.push_back({encode(Leave{}), true});
}

void HollowSession::receive(std::span<const std::uint8_t> bytes, Moment now) {
  if (ending_) return;
  const std::optional<ToClient> message = decodeToClient(bytes);
  if (message) return std::visit([&](const auto& content) { handle(content, now); }, *message);
  ending_ = "protocol error: malformed message from the server";
}

void HollowSession::startRound(std::uint32_t id, double lead) {
  round_ = Round(id, lead);
  round_.confirmed.sync = kUnknownSync;
  state_.clear();
}

void HollowSession::handle(const Welcome& message, Moment now) {
  welcome_ = message;
  startRound(message.round, PredictionClock::initialLead(now - helloAt_));
}

void HollowSession::handle(const Refused& message, Moment) {
  ending_ = "the server refused this client: " + message.reason;
}

void HollowSession::handle(const Bye& message, Moment) { ending_ = "the server ended the game: " + message.reason; }

void HollowSession::handle(const LevelChunk& message, Moment) {
  hasLevel_ = hasLevel_ || levelText_.add(message.total, message.offset, message.bytes);
}

void HollowSession::handle(const RoundStart& message, Moment) { startRound(message.round, round_.clock.lead()); }

// The hash of this state is unknown until the ticks after it arrive.
void HollowSession::handle(const StateChunk& message, Moment) {
  if (message.round != round_.id || !state_.add(message.total, message.offset, message.bytes)) return;
  state_.clear();
  round_.confirmed = {message.tick, 0, kUnknownSync};
  round_.sync = message.sync;
}

void HollowSession::handle(const ConfirmedTicks& message, Moment now) {
  linkMeter_.receive(message, now);
  if (message.round != round_.id || !hasLevel_) return;
  round_.clock.receive(message, now);
  const std::uint32_t newest = message.from + message.count;
  const std::uint32_t confirmed = round_.confirmed.ticks;
  if (confirmed < message.from || confirmed >= newest) return;
  confirmedTicks_ += newest - confirmed;
  round_.confirmed = {newest, message.hash, round_.sync};
}

void HollowSession::update(Moment now, const Buttons& buttons) {
  if (ending_ || !hasLevel_) return;
  chooseInputs(now, buttons);
  std::optional<PlayerInputs> message = round_.sender.takeMessage(now, round_.confirmed);
  if (!message) return;
  message->sequence = linkMeter_.nextSequence(now);
  outgoing_.push_back({encode(*message), false});
}

void HollowSession::chooseInputs(Moment now, const Buttons& buttons) {
  const std::uint32_t confirmed = round_.confirmed.ticks;
  const std::uint32_t end = confirmed + std::min(kMaxInputsPerMessage, UINT32_MAX - confirmed);
  round_.next = std::max(round_.next, confirmed);
  round_.clock.update(now, round_.next);
  for (; round_.next < end && round_.clock.reaches(round_.next); ++round_.next) {
    if (round_.next < round_.clock.firstInput()) continue;
    const auto pressed = static_cast<std::uint8_t>(buttons().buttons | Input::kPresent);
    round_.clock.inputChosen(round_.next);
    round_.sender.add(round_.next, Input{pressed});
  }
}

LinkStatistics HollowSession::linkStatistics() const { return linkMeter_.statistics(&round_.clock); }

}  // namespace platon
