#include "client/network_client.h"

namespace platon {

NetworkClient::NetworkClient(const ServerAddress& server, const std::string& name, Moment now,
                             const std::optional<ServerAddress>& way)
    : server_(server), name_(name), connection_(way.value_or(server), now), waitingSince_(now) {}

void NetworkClient::update(Moment now, const Controls& controls) {
  connection_.service(now, [this, now](std::span<const std::uint8_t> message) {
    if (session_) session_->receive(message, now);
  });
  if (!session_ && connection_.state() == Connection::State::kConnected) {
    session_.emplace(name_, now);
    waitingSince_ = now;
  }
  if (!ending_ && !leaving_) ending_ = findEnding(now);
  if (!session_) return;
  if (ending_) session_->lose(*ending_);
  if (!leaving_ && !ending_) session_->update(now, controls);
  for (const OutgoingMessage& message : session_->takeOutgoing()) connection_.send(message.bytes, message.reliable);
  if (leaving_) connection_.close();
  connection_.flush(now);
}

void NetworkClient::leave() {
  leaving_ = true;
  if (session_) session_->leave();
}

std::optional<MismatchReport> NetworkClient::takeMismatch() {
  return session_ ? session_->takeMismatch() : std::nullopt;
}

std::optional<std::string> NetworkClient::findEnding(Moment now) const {
  if (session_ && session_->ending()) return session_->ending();
  const bool welcomed = session_ && session_->welcome();
  if (!welcomed && (closed() || now - waitingSince_ > kPatience)) {
    return "no answer from " + server_.text() + " within 5 s: is platon-server running there?";
  }
  if (closed()) return "the connection to " + server_.text() + " is lost";
  return std::nullopt;
}

}  // namespace platon
