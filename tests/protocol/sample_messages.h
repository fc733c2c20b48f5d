#pragma once

#include <vector>

#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

inline Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

/// At least one message of each kind, with the smallest and largest values.
std::vector<ToServer> sampleToServer();
std::vector<ToClient> sampleToClient();

/// Encodes a message of any kind.
template <class Variant>
std::vector<std::uint8_t> encodeAny(const Variant& message) {
  return std::visit([](const auto& body) { return encode(body); }, message);
}

}  // namespace platon
