#include <optional>
#include <variant>

#include "protocol/full_state.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

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
    case 0:
      return roundTripFault(bytes.remaining(), &decodeToServer);
    case 1:
      return roundTripFault(bytes.remaining(), &decodeToClient);
    default:
      return stateFault(bytes.remaining());
  }
}

}  // namespace platon::fuzz
