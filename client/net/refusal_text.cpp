#include "client/net/refusal_text.h"

#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/version_text.h"

namespace platon {
namespace {

std::string bannedText(const std::string& reason) {
  return reason.empty() ? "you are banned from this server" : reason;
}

Connection::Refused explain(const Refusal& refusal) {
  switch (refusal.reason) {
    case RefusalReason::kWrongVersion:
      return {otherVersionText("protocol", refusal.version, kProtocolVersion), true};
    case RefusalReason::kFull:
      return {"the server has no free connection: try again later", false};
    case RefusalReason::kAddress:
      return {"the server does not allow more connections from your address", false};
    case RefusalReason::kBanned:
      return {bannedText(visibleLabel(refusal.text)), true};
    case RefusalReason::kPassword:
      return {"the password is wrong", true, true};
  }
  return {"the server refused the connection", true};
}

}  // namespace

Connection::Refused refusalOf(const ClientGate& gate) {
  if (gate.state() == ClientGate::State::kNoPassword)
    return {"the server needs a password: write it to a file and name the file after --password-file", true, true};
  if (gate.state() == ClientGate::State::kNoPasswordAsked)
    return {"the server does not ask for a password: leave out --password-file if that is right", true};
  if (gate.state() == ClientGate::State::kAnotherIdentity)
    return {"the server is not the one that this program knows at " + gate.server().text() +
                ": either its owner gave it a new key, or somebody answers in its place. If you trust it, remove its "
                "line from "
                "the file known_servers",
            true};
  return explain(*gate.refusal());
}

}  // namespace platon
