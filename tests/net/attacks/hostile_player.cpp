#include "tests/net/attacks/hostile_player.h"

namespace platon {
namespace {

constexpr Time kPause = std::chrono::milliseconds(100);  // between two attempts to join
constexpr Time kExtraInterval = std::chrono::milliseconds(10);

Bytes encodeAny(const ToServer& message) {
  return std::visit([](const auto& body) { return encode(body); }, message);
}

}  // namespace

void HostilePlayer::step(Time now) {
  const bool ended =
      connection_ && (connection_->state() == EnetLink::State::kClosed || (session_ && session_->ending()));
  const bool tooOld = connection_ && now - since_ >= manners_.life;
  if (!connection_ || tooOld || (ended && now - since_ >= kPause)) begin(now);
  const bool deaf = manners_.deafAfter && session_ && now - since_ >= *manners_.deafAfter;
  if (!deaf) {
    connection_->service(now, [&](std::span<const std::uint8_t> message) { receive(message, now); });
  }
  if (!session_ && connection_->state() == EnetLink::State::kConnected) session_.emplace(name_, now);
  if (session_) play(now);
  connection_->flush(now);
}

void HostilePlayer::begin(Time now) {
  if (session_ && manners_.leaves) {
    session_->leave();
    send();
    connection_->flush(now);
  }
  session_.reset();
  welcome_.reset();
  connection_.emplace(network_.socket(own_), std::vector{network_.server()}, ServerKnowledge{});
  since_ = now;
}

void HostilePlayer::receive(std::span<const std::uint8_t> message, Time now) {
  if (!session_) return;
  session_->receive(message, now);
  const std::optional<ToClient> decoded = decodeToClient(message);
  const Welcome* const welcome = decoded ? std::get_if<Welcome>(&*decoded) : nullptr;
  if (welcome != nullptr) welcome_ = *welcome;
}

void HostilePlayer::play(Time now) {
  session_->update(now, [this] { return presser_.next(); });
  send();
  if (!manners_.extra || !welcome_ || now - extraAt_ < kExtraInterval) return;
  extraAt_ = now;
  manners_.extra(*connection_, *welcome_, dice_);
}

void HostilePlayer::send() {
  for (const OutgoingMessage& message : session_->takeOutgoing()) {
    std::optional<ToServer> decoded = decodeToServer(message.bytes);
    if (decoded && manners_.tamper) manners_.tamper(*decoded, network_, dice_);
    connection_->send(decoded ? encodeAny(*decoded) : message.bytes, message.reliable);
  }
}

}  // namespace platon
