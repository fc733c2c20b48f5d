#include <optional>
#include <variant>

#include "protocol/full_state.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

// What is let in is within its limits: `encode` asserts them.
template <class Message>
std::string roundTripFault(Bytes bytes, std::optional<Message> (*decode)(Bytes)) {
  const std::optional<Message> message = decode(bytes);
  if (!message) return {};
  const auto again = std::visit([](const auto& body) { return encode(body); }, *message);
  return decode(again) == message ? std::string() : "a message is another one when encoded and decoded";
}

std::string stateFault(Bytes bytes) {
  const std::optional<FullState> state = decodeFullState(bytes);
  if (!state || decodeFullState(encode(*state)) == state) return {};
  return "a full state is another one when encoded and decoded";
}

}  // namespace

std::string protocolFault(Bytes input) {
  ByteSource bytes(input);
  switch (bytes.below(3)) {
    case 0:
      return roundTripFault(bytes.rest(), &decodeToServer);
    case 1:
      return roundTripFault(bytes.rest(), &decodeToClient);
    default:
      return stateFault(bytes.rest());
  }
}

}  // namespace platon::fuzz
