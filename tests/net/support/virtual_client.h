#pragma once

#include <cstdint>
#include <vector>

#include "client/session/dialogue.h"
#include "protocol/time.h"

namespace platon {

/// A client of a VirtualNetwork.
class VirtualClient {
 public:
  virtual ~VirtualClient() = default;

  /// A message from the server.
  virtual void receive(std::vector<std::uint8_t> bytes, Time now) = 0;
  /// Called in every step of the network, before the messages to send are taken.
  virtual void update(Time now) = 0;
  /// The messages to send now, in order.
  virtual std::vector<OutgoingMessage> takeOutgoing() = 0;
};

}  // namespace platon
