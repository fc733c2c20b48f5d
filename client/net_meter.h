#pragma once

#include <cstdint>
#include <deque>

#include "client/moment.h"
#include "client/net_graph.h"
#include "client/network_client.h"

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

  std::deque<Reading> readings_;          // of the last second, oldest first
  std::uint32_t corrections_ = 0;
};

}  // namespace platon
