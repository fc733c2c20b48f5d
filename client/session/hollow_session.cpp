#include "client/session/hollow_session.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace platon {

namespace {

// Of a state that was never sent. The server takes the inputs of a message with it, and does not judge its hash.
constexpr std::uint8_t kNoSync = 255;

}  // namespace

HollowSession::HollowSession(const std::string& name, Moment now) : helloAt_(now) {
  Hello hello;
  hello.name = name;
  outgoing_.push_back({encode(hello), true});
}

void HollowSession::leave() {
  if (!ending_) outgoing_.push_back({encode(Leave{}), true});
}

void HollowSession::receive(std::span<const std::uint8_t> bytes, Moment now) {
  if (ending_) return;
  const std::optional<ToClient> message = decodeToClient(bytes);
  if (message) return std::visit([&](const auto& content) { handle(content, now); }, *message);
  ending_ = "the server sent a message that this client does not understand";
}

void HollowSession::handle(const Welcome& message, Moment now) {
  round_ = message.round;
  clock_ = InputClock(InputClock::firstLead(now - helloAt_));
}

void HollowSession::handle(const Refused& message, Moment) {
  ending_ = "the server refused this client: " + message.reason;
}

void HollowSession::handle(const Bye& message, Moment) { ending_ = "the server ended the game: " + message.reason; }

void HollowSession::handle(const LevelChunk& message, Moment) {
  ready_ = ready_ || levelText_.add(message.total, message.offset, message.bytes);
}

void HollowSession::handle(const RoundStart& message, Moment) {
  round_ = message.round;
  clock_ = InputClock(clock_.lead());
  schedule_ = ReportSchedule();
  standing_ = Standing();
  hash_.reset();
  next_ = 0;
  state_.clear();
  pastTicks_ += std::exchange(heardTicks_, 0);
}

// The hash of the state is not told, but that of the ticks which follow on it will be.
void HollowSession::handle(const StateChunk& message, Moment) {
  if (message.round != round_ || !state_.add(message.total, message.offset, message.bytes)) return;
  state_.clear();
  standing_ = {message.tick, message.sync};
  hash_.reset();
}

void HollowSession::handle(const ConfirmedTicks& message, Moment now) {
  line_.receive(message, now);
  if (message.round != round_ || !ready_) return;
  clock_.receive(message, now);
  const std::uint32_t newest = message.from + message.count;
  if (standing_.ticks < message.from || standing_.ticks >= newest) return;
  heardTicks_ += newest - standing_.ticks;
  standing_.ticks = newest;
  hash_ = message.hash;
}

void HollowSession::update(Moment now, const Buttons& buttons) {
  if (ending_ || !ready_) return;
  choose(now, buttons);
  if (!schedule_.due(now, next_)) return;
  PlayerInputs message = report();
  message.sequence = line_.send(now);
  schedule_.told(now, next_);
  outgoing_.push_back({encode(message), false});
}

void HollowSession::choose(Moment now, const Buttons& buttons) {
  next_ = std::max(next_, standing_.ticks);
  clock_.update(now, next_);
  for (; clock_.reaches(next_) && next_ - standing_.ticks < own_.size(); ++next_) {
    Input& own = own_[next_ % own_.size()];
    own = Input();
    if (next_ < clock_.firstInput()) continue;
    own.buttons = buttons().buttons | Input::kPresent;
    clock_.chose(next_);
    schedule_.chose(own);
  }
}

PlayerInputs HollowSession::report() {
  const std::uint8_t sync = hash_ ? standing_.sync : kNoSync;
  PlayerInputs message{round_, sync, standing_.ticks, hash_.value_or(0), 0, {}};
  message.first = std::max(standing_.ticks, clock_.firstInput());
  for (std::uint32_t tick = message.first; tick < next_; ++tick) message.inputs.push_back(own_[tick % own_.size()]);
  return message;
}

LinkStatistics HollowSession::reading() const {
  return readingOf(line_, clock_.sync() ? &*clock_.sync() : nullptr, clock_.slack());
}

}  // namespace platon
