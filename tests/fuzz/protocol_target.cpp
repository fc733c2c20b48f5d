#include <optional>
#include <variant>

#include "protocol/label.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transfer.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

// What is shown of a name can be shown, is not longer, and is taken for the name itself.
std::string nameFault(const std::string& name) {
  const std::string visible = visibleLabel(name);
  if (!isLabel(visible, name.size()) || visibleLabel(visible) != visible)
    return "a name is shown with what is not seen";
  return lookAlikeKey(visible) == lookAlikeKey(name) ? std::string() : "what is shown of a name is another name";
}

std::string helloFault(Bytes bytes) {
  const std::optional<ToServer> message = decodeToServer(bytes);
  const auto* const hello = message ? std::get_if<Hello>(&*message) : nullptr;
  return hello == nullptr ? std::string() : nameFault(hello->name);
}

// A decoded message is within its limits, which `encode` asserts.
template <class Message>
std::string roundTripFault(Bytes bytes, std::optional<Message> (*decode)(Bytes)) {
  const std::optional<Message> message = decode(bytes);
  if (!message) return {};
  const auto again = std::visit([](const auto& body) { return encode(body); }, *message);
  return decode(again) == message ? std::string() : "a message differs after encoding and decoding";
}

std::string stateFault(Bytes bytes) {
  const std::optional<FullState> state = decodeFullState(bytes);
  if (!state || decodeFullState(encode(*state)) == state) return {};
  return "a full state differs after encoding and decoding";
}

}  // namespace

std::string protocolFault(Bytes input) {
  ByteSource bytes(input);
  switch (bytes.below(3)) {
    case 0: {
      const std::string fault = helloFault(bytes.remaining());
      return fault.empty() ? roundTripFault(bytes.remaining(), &decodeToServer) : fault;
    }
    case 1:
      return roundTripFault(bytes.remaining(), &decodeToClient);
    default:
      return stateFault(bytes.remaining());
  }
}

}  // namespace platon::fuzz
