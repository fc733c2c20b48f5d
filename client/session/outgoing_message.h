#pragma once

#include <cstdint>
#include <vector>

namespace platon {

/// An encoded message to the server.
struct OutgoingMessage {
  std::vector<std::uint8_t> bytes;
  bool reliable = false;  ///< reliable channel if true, else unsequenced on the tick channel
};

}  // namespace platon
