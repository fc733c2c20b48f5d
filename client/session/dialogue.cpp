#include "client/session/dialogue.h"

#include "client/netcode/prediction_clock.h"
#include "protocol/label.h"
#include "protocol/transport/server_address.h"

namespace platon {

Dialogue::Dialogue(const Hello& hello, Time now) : helloAt_(now), receivedAt_(now) { send(hello, true); }

std::optional<ToClient> Dialogue::receive(std::span<const std::uint8_t> bytes, Time now) {
  receivedAt_ = now;
  std::optional<ToClient> message = decodeToClient(bytes);
  if (!message) end({"protocol error: malformed message from the server", true});
  return message;
}

std::optional<double> Dialogue::begin(const Welcome& message, Time now) {
  if (welcome_) {
    end({"protocol error: second Welcome from the server", true});
    return std::nullopt;
  }
  welcome_ = message;
  return PredictionClock::initialLead(now - helloAt_);
}

// A full server may have a free slot later, and a stopping one may restart, unless it names another one.
void Dialogue::end(const Refused& message) {
  endAsTold("the server refused this client", message.reason, message.code != RefusalCode::kFull, message.next);
}

void Dialogue::end(const Bye& message) {
  endAsTold("the server ended the game", message.reason, message.code != ByeCode::kServerStops, message.next);
}

void Dialogue::endAsTold(const char* what, const std::string& why, bool permanent, const std::string& next) {
  const std::string reason = visibleLabel(why);
  const bool goesOn = isNextServer(next);
  end({reason.empty() ? what : what + (": " + reason), permanent || goesOn, goesOn ? next : ""});
}

void Dialogue::sendInputs(PlayerInputs message, Time now) {
  message.sequence = linkMeter_.nextSequence(now);
  send(message, false);
}

}  // namespace platon
