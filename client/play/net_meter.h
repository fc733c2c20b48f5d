#pragma once

#include <cstdint>
#include <deque>

#include "client/session/network_client.h"
#include "client/time/moment.h"
#include "client/ui/net_graph.h"

namespace platon {

/// Takes samples of how a connection does, for the graph.
class NetMeter {
 public:
  /// One sample, of this frame; rates are over the last second. The client is connected.
  NetSample sample(const NetworkClient& client, Moment now);

 private:
  struct Reading {
    Moment at;
    Traffic traffic;
  };

  std::deque<Reading> readings_;  // of the last second, oldest first
  std::uint32_t corrections_ = 0;
};

}  // namespace platon
